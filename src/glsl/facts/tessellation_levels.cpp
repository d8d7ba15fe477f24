// The uniforms that decide tessellation levels and nothing else. The search follows a value through the
// control stage, statement by statement, and gives up at every statement that it does not understand.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

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
    Flow(const Unit& unit, std::string_view from)
        : unit_(unit), reached_{from, "gl_TessLevelOuter", "gl_TessLevelInner"}, carriers_{from} {}

    /// True if levels depend on the uniform, perhaps through local variables, and nothing else does.
    bool decidesLevelsAlone() {
        // Loops carry values back, so the stage is read until nothing new is reached.
        for (std::size_t known = 0; known != reached_.size() + carriers_.size();) {
            known = reached_.size() + carriers_.size();
            for (const Declaration& each : unit_.syntax.declarations) {
                if (each.code == kNone
                        ? !understands(each)
                        : isReached({each.tokens.first, each.body.first}) || !understands(each.code))
                    return false;
            }
        }
        return reachesLevel_;
    }

  private:
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] bool hasOneOf(Range range, const std::set<std::string_view>& words) const {
        for (std::uint32_t at = range.first; at < range.end; ++at)
            if (words.contains(unit_.text(at))) return true;
        return false;
    }
    [[nodiscard]] bool isReached(Range range) const { return hasOneOf(range, reached_); }

    /// True if the statement does not touch what is reached, or is an assignment that passes it on.
    bool understands(std::uint32_t id) {
        const Node& it = node(id);
        if (it.kind == NodeKind::declaration) return understands(unit_.bodies.declarations[it.token]);
        if (it.kind > NodeKind::choice)
            return !isReached(it.range()) || (it.kind == NodeKind::evaluation && passesOn({}, it.child));
        for (const std::uint32_t each : unit_.bodies.children(id)) {
            const bool isBody =
                it.kind == NodeKind::block || (it.kind == NodeKind::branch   ? each != it.child
                                               : it.kind == NodeKind::doLoop ? each == it.child
                                                                             : each == it.lastChild);
            if (!(isBody ? understands(each) : !isReached(node(each).range()))) return false;
        }
        return true;
    }

    bool understands(const Declaration& declaration) {
        if (declaration.qualifiers.storage == Storage::uniform) return true;
        const bool isPlain = declaration.qualifiers.tokens.empty() && isType(declaration.type.name) &&
                             !declaration.declarators.empty();
        if (isPlain) locals_.insert(unit_.text(declaration.declarators.front().name));
        if (!isReached(declaration.tokens)) return true;
        if (!isPlain || declaration.declarators.size() > 1) return false;
        const Declarator& name = declaration.declarators.front();
        return name.dimensions.empty() && name.value != kNone &&
               passesOn({{name.name, name.name + 1}}, name.value);
    }

    /// True for a = b = value, where a and b are levels or local variables.
    bool passesOn(std::vector<Range> places, std::uint32_t value) {
        for (; node(value).kind == NodeKind::assignment; value = node(value).lastChild)
            places.push_back(node(node(value).child).range());
        const Range range = node(value).range();
        return !places.empty() && isPure(range) &&
               std::ranges::all_of(places, [&](Range each) { return takes(each, range); });
    }

    /// True if `place` is a level or a local variable; notes that it now depends on `value`.
    bool takes(Range place, Range value) {
        if (place.empty() || isReached({place.first + 1, place.end})) return false;
        const std::string_view name = unit_.text(place.first);
        const bool carries = hasOneOf(value, carriers_);
        if (isLevelOutput(name)) {
            reachesLevel_ = reachesLevel_ || carries;
            return true;
        }
        if (place.end != place.first + 1 || !locals_.contains(name)) return false;
        reached_.insert(name);
        if (carries) carriers_.insert(name);
        return true;
    }

    [[nodiscard]] bool isPure(Range value) const {
        for (std::uint32_t at = value.first; at < value.end; ++at) {
            const std::string_view text = unit_.text(at);
            if (text == "?" || isStep(text) || isAssignment(text)) return false;
            const bool isCall = unit_.view[at].kind == TokenKind::word && unit_.text(at + 1) == "(";
            if (isCall && !isPureFunction(text)) return false;
        }
        return true;
    }

    const Unit& unit_;
    std::set<std::string_view> reached_;   ///< the uniform, what may depend on it, and the levels
    std::set<std::string_view> carriers_;  ///< the uniform and the variables computed from it
    std::set<std::string_view> locals_;
    bool reachesLevel_ = false;
};

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
    for (const Variable& each : control->variables) {
        const bool isScalar = (each.type == "float" || each.type == "int") && !each.isArray();
        if (each.storage == Storage::uniform && !each.removed && isScalar &&
            isOnlyInControl(program, each.name) && Flow(*control, each.name).decidesLevelsAlone())
            found.insert(each.name);
    }
    return found;
}

}  // namespace glibra::glsl
