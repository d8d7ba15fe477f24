#include "budget/level_uniforms.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>

#include "budget/program_facts.h"

namespace glibra::budget {
namespace {

using Tokens = std::vector<std::string_view>;

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Words, numbers and operators, without comments. A preprocessor line other than #line, #version and
/// #extension stays, with the token "#", which no rule below knows.
Tokens tokensOf(std::string_view text) {
    Tokens tokens;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (std::isspace(static_cast<unsigned char>(rest.front())) != 0) {
            ++at;
        } else if (rest.starts_with("//") || rest.front() == '#') {
            const bool isHarmless = rest.front() == '/' || rest.starts_with("#line") ||
                                    rest.starts_with("#version") || rest.starts_with("#extension");
            if (!isHarmless) tokens.push_back(rest.substr(0, 1));
            at = isHarmless ? std::min(text.size(), text.find('\n', at)) : at + 1;
        } else if (rest.starts_with("/*")) {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string_view::npos ? text.size() : end + 2;
        } else if (isWordCharacter(rest.front())) {
            const auto end = std::find_if_not(rest.begin(), rest.end(), isWordCharacter);
            tokens.push_back(rest.substr(0, static_cast<std::size_t>(end - rest.begin())));
            at += tokens.back().size();
        } else {
            const bool isDouble = rest.size() > 1 && rest[1] == '=' &&
                                  std::string_view("=<>!+-*/").find(rest[0]) != std::string_view::npos;
            tokens.push_back(rest.substr(0, isDouble ? 2 : 1));
            at += tokens.back().size();
        }
    }
    return tokens;
}

template <std::size_t count>
bool isOneOf(std::string_view word, const std::array<std::string_view, count>& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool isLevelOutput(std::string_view word) {
    return word == "gl_TessLevelOuter" || word == "gl_TessLevelInner";
}
bool isType(std::string_view word) {
    return isOneOf(word, std::array<std::string_view, 8>{"float", "int", "uint", "vec2", "vec3", "vec4",
                                                         "double", "ivec2"});
}
/// Functions without effects but their value.
bool isPureFunction(std::string_view word) {
    return isType(word) || isOneOf(word, std::array<std::string_view, 20>{
                                             "max", "min",  "clamp", "mix",   "ceil",   "floor",      "round",
                                             "abs", "sqrt", "pow",   "exp2",  "log2",   "exp",        "log",
                                             "mod", "step", "fract", "trunc", "length", "inversesqrt"});
}

/// What a value can reach in a control stage, statement by statement.
class Flow {
  public:
    explicit Flow(std::string_view from)
        : reached_{from, "gl_TessLevelOuter", "gl_TessLevelInner"}, carriers_{from} {}

    /// True if levels depend on it, perhaps by way of local variables, and nothing else does.
    bool decidesLevelsAlone(const Tokens& tokens) {
        for (std::size_t known = 0; known != reached_.size() + carriers_.size();) {  // loops carry back
            known = reached_.size() + carriers_.size();
            auto begin = tokens.begin();
            while (begin != tokens.end()) {
                const auto end = std::find_if(begin, tokens.end(), [](std::string_view token) {
                    return token == ";" || token == "{" || token == "}";
                });
                if (!understands(Tokens(begin, end))) return false;
                begin = end == tokens.end() ? end : end + 1;
            }
        }
        return reachesLevel_;
    }

  private:
    static bool hasOneOf(const Tokens& tokens, const std::set<std::string_view>& words) {
        return std::any_of(tokens.begin(), tokens.end(),
                           [&](std::string_view each) { return words.contains(each); });
    }
    [[nodiscard]] bool isReached(const Tokens& tokens) const { return hasOneOf(tokens, reached_); }

    bool understands(Tokens statement) {
        while (!statement.empty() && (statement.front() == "if" || statement.front() == "else")) {
            if (statement.front() == "else") {
                statement.erase(statement.begin());
                continue;
            }
            auto end = statement.begin() + 1;
            for (int depth = 0; end != statement.end(); ++end) {
                depth += *end == "(" ? 1 : *end == ")" ? -1 : 0;
                if (depth == 0) break;
            }
            if (end == statement.end() || isReached(Tokens(statement.begin(), end))) return false;
            statement.erase(statement.begin(), end + 1);
        }
        if (std::find(statement.begin(), statement.end(), "uniform") != statement.end()) return true;
        noteDeclaration(statement);
        return !isReached(statement) || isAssignment(statement);
    }

    void noteDeclaration(Tokens& statement) {
        if (statement.size() < 2 || !isType(statement[0]) || !isWordCharacter(statement[1].front())) return;
        locals_.insert(statement[1]);
        statement.erase(statement.begin());
    }

    /// a = b = value, with a and b levels or local variables.
    bool isAssignment(const Tokens& statement) {
        auto begin = statement.begin();
        std::vector<Tokens> places;
        for (auto at = begin; at != statement.end(); ++at)
            if (at->size() <= 2 && at->back() == '=' && !isOneOf(*at, kComparisons)) {
                places.emplace_back(begin, at);
                begin = at + 1;
            }
        const Tokens value(begin, statement.end());
        if (places.empty() || !isPure(value)) return false;
        for (const Tokens& each : places) {
            if (each.empty() || isReached(Tokens(each.begin() + 1, each.end()))) return false;
            if (isLevelOutput(each.front())) {
                reachesLevel_ = reachesLevel_ || hasOneOf(value, carriers_);
                continue;
            }
            if (each.size() != 1 || !locals_.contains(each.front())) return false;
            reached_.insert(each.front());
            if (hasOneOf(value, carriers_)) carriers_.insert(each.front());
        }
        return true;
    }

    static bool isPure(const Tokens& value) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (value[i] == "#" || value[i] == "?") return false;
            const bool isCall =
                i + 1 < value.size() && value[i + 1] == "(" && isWordCharacter(value[i].front());
            if (isCall && !isPureFunction(value[i])) return false;
            if (i + 1 < value.size() && value[i] == value[i + 1] && (value[i] == "+" || value[i] == "-"))
                return false;
        }
        return true;
    }

    static constexpr std::array<std::string_view, 4> kComparisons{"==", "<=", ">=", "!="};
    std::set<std::string_view> reached_;   ///< and the levels themselves
    std::set<std::string_view> carriers_;  ///< the uniform, and variables made of it
    std::set<std::string_view> locals_;
    bool reachesLevel_ = false;
};

/// Its name in the sources that the driver gets.
std::string emittedName(const plan::ProgramInterface& program, const std::string& name) {
    for (const auto& [emitted, user] : program.facts.userNames)
        if (user == name) return emitted;
    return name;
}

bool decidesLevelsAlone(const plan::ProgramInterface& program, const plan::ActiveUniform& uniform) {
    const bool isScalar =
        uniform.type.components() == 1 && !uniform.isArray && uniform.block < 0 &&
        (uniform.type.base == plan::BaseType::floating || uniform.type.base == plan::BaseType::integer);
    if (!isScalar) return false;
    const std::string name = emittedName(program, uniform.name);
    bool isInControl = false;
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        if (each.stage == glsl::Stage::geometry) return false;
        if (each.stage != glsl::Stage::tessControl) {
            if (hasWord(each.source, name) || hasWord(each.source, "gl_TessLevelOuter") ||
                hasWord(each.source, "gl_TessLevelInner"))
                return false;
            continue;
        }
        isInControl = hasWord(each.source, name);
        if (!isInControl || !Flow(name).decidesLevelsAlone(tokensOf(each.source))) return false;
    }
    return isInControl;
}

}  // namespace

std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel) {
    std::vector<LevelUniform> found;
    if (program.interface->facts.tessellationOutput == "points") return found;
    for (const plan::UniformBinding& binding : program.values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        if (!literal || literal->values.size() != 1 || !(literal->values[0] > 0)) continue;
        const plan::ActiveUniform& uniform = at(program.interface->uniforms, binding.uniform);
        if (!decidesLevelsAlone(*program.interface, uniform)) continue;
        LevelUniform level{binding.uniform, literal->values[0], 1, mostLevel};
        for (const plan::Control& control : program.controls)
            if (control.uniform == binding.uniform && control.maximum > 0) {
                level.least = std::max(control.minimum, std::min(1., control.maximum));
                level.most = control.maximum;
            }
        found.push_back(level);
    }
    return found;
}

}  // namespace glibra::budget
