// The uniforms that decide tessellation levels and nothing else. The search follows a value through the
// control stage, statement by statement, and gives up at every statement that it does not understand.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

using Tokens = std::vector<std::string_view>;

bool isWord(std::string_view token) {
    return !token.empty() && base::beginsName(token.front());
}

bool isLevelOutput(std::string_view word) {
    return word == "gl_TessLevelOuter" || word == "gl_TessLevelInner";
}

bool isType(std::string_view word) {
    return listed(" float int uint vec2 vec3 vec4 double ivec2 ", word);
}

/// Functions that have no effect except their value.
bool isPureFunction(std::string_view word) {
    constexpr std::string_view kPure =
        " max min clamp mix ceil floor round abs sqrt pow exp2 log2 exp log mod step fract trunc length "
        "inversesqrt ";
    return isType(word) || listed(kPure, word);
}

/// Everything in a control stage that the value of one uniform can reach.
class Flow {
  public:
    explicit Flow(std::string_view from)
        : reached_{from, "gl_TessLevelOuter", "gl_TessLevelInner"}, carriers_{from} {}

    /// True if levels depend on the uniform, perhaps through local variables, and nothing else does.
    bool decidesLevelsAlone(const Tokens& tokens) {
        // Loops carry values back, so the stage is read until nothing new is reached.
        for (std::size_t known = 0; known != reached_.size() + carriers_.size();) {
            known = reached_.size() + carriers_.size();
            if (!understandsAll(tokens)) return false;
        }
        return reachesLevel_;
    }

  private:
    static bool hasOneOf(const Tokens& tokens, const std::set<std::string_view>& words) {
        return std::ranges::any_of(tokens, [&](std::string_view each) { return words.contains(each); });
    }
    [[nodiscard]] bool isReached(const Tokens& tokens) const { return hasOneOf(tokens, reached_); }

    /// The token after the parenthesis that closes the one at `open`.
    static Tokens::const_iterator endOfParentheses(Tokens::const_iterator open, Tokens::const_iterator end) {
        int depth = 0;
        for (; open != end; ++open) {
            depth += *open == "(" ? 1 : *open == ")" ? -1 : 0;
            if (depth == 0) return open + 1;
        }
        return end;
    }

    bool understandsAll(const Tokens& tokens) {
        for (auto begin = tokens.begin(); begin != tokens.end();) {
            // What these control is read like any statement.
            if (*begin == "if" || *begin == "else" || *begin == "for" || *begin == "while") {
                const auto end = *begin == "else" ? begin + 1 : endOfParentheses(begin + 1, tokens.end());
                if (isReached(Tokens(begin, end))) return false;
                begin = end;
                continue;
            }
            const auto end = std::find_if(begin, tokens.end(), [](std::string_view token) {
                return token == ";" || token == "{" || token == "}";
            });
            if (!understands(Tokens(begin, end))) return false;
            begin = end == tokens.end() ? end : end + 1;
        }
        return true;
    }

    /// True if the statement does not touch what is reached, or is an assignment that passes it on.
    bool understands(Tokens statement) {
        if (std::ranges::find(statement, "uniform") != statement.end()) return true;
        noteDeclaration(statement);
        return !isReached(statement) || passesOn(statement);
    }

    void noteDeclaration(Tokens& statement) {
        if (statement.size() < 2 || !isType(statement[0]) || !isWord(statement[1])) return;
        locals_.insert(statement[1]);
        statement.erase(statement.begin());
    }

    /// True for a = b = value, where a and b are levels or local variables.
    bool passesOn(const Tokens& statement) {
        auto begin = statement.begin();
        std::vector<Tokens> places;
        for (auto at = begin; at != statement.end(); ++at)
            if (isAssignment(*at)) {
                places.emplace_back(begin, at);
                begin = at + 1;
            }
        const Tokens value(begin, statement.end());
        return !places.empty() && isPure(value) &&
               std::ranges::all_of(places, [&](const Tokens& each) { return takes(each, value); });
    }

    /// True if `place` is a level or a local variable; notes that it now depends on `value`.
    bool takes(const Tokens& place, const Tokens& value) {
        if (place.empty() || isReached(Tokens(place.begin() + 1, place.end()))) return false;
        const bool carries = hasOneOf(value, carriers_);
        if (isLevelOutput(place.front())) {
            reachesLevel_ = reachesLevel_ || carries;
            return true;
        }
        if (place.size() != 1 || !locals_.contains(place.front())) return false;
        reached_.insert(place.front());
        if (carries) carriers_.insert(place.front());
        return true;
    }

    static bool isPure(const Tokens& value) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (value[i] == "?" || value[i] == "++" || value[i] == "--") return false;
            const bool isCall = i + 1 < value.size() && value[i + 1] == "(" && isWord(value[i]);
            if (isCall && !isPureFunction(value[i])) return false;
        }
        return true;
    }

    std::set<std::string_view> reached_;   ///< the uniform, what may depend on it, and the levels
    std::set<std::string_view> carriers_;  ///< the uniform and the variables computed from it
    std::set<std::string_view> locals_;
    bool reachesLevel_ = false;
};

Tokens tokensOf(const Unit& unit) {
    Tokens tokens;
    tokens.reserve(unit.view.size());
    for (const ViewToken& each : unit.view) tokens.push_back(each.text);
    return tokens;
}

/// True if no stage except the control stage names the word.
bool isOnlyInControl(const ProgramUnits& program, std::string_view word) {
    return std::ranges::none_of(program.units, [&](const Unit& unit) {
        return unit.stage != Stage::tessControl &&
               std::ranges::any_of(unit.view, [&](const ViewToken& each) { return each.text == word; });
    });
}

}  // namespace

std::set<std::string> findLevelUniforms(const ProgramUnits& program) {
    std::set<std::string> found;
    const Unit* control = nullptr;
    for (const Unit& each : program.units) {
        if (each.stage == Stage::geometry) return found;
        if (each.stage == Stage::tessControl) control = &each;
    }
    if (control == nullptr || program.result->tessellationOutput == "points" ||
        !isOnlyInControl(program, "gl_TessLevelOuter") || !isOnlyInControl(program, "gl_TessLevelInner"))
        return found;
    const Tokens tokens = tokensOf(*control);
    for (const Variable& each : control->variables) {
        const bool isScalar = (each.type == "float" || each.type == "int") && !each.isArray();
        if (each.storage == Storage::uniform && !each.removed && isScalar &&
            isOnlyInControl(program, each.name) && Flow(each.name).decidesLevelsAlone(tokens))
            found.insert(each.name);
    }
    return found;
}

}  // namespace glibra::glsl
