// How far a stage reaches: the vertices of a patch that it reads, the vertices that it may emit, the axes
// along which it distinguishes invocations, and the elements of buffers that it names.

#include <algorithm>
#include <array>
#include <string_view>

#include "glsl/facts/facts.h"
#include "glsl/facts/formula.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// What limits a number; equality does not, since `if (gl_InvocationID == 0)` only picks one of them.
bool isComparison(std::string_view text) {
    constexpr std::array<std::string_view, 7> kComparing{"<", ">", "<=", ">=", "%", "&", ">>"};
    return std::ranges::find(kComparing, text) != kComparing.end();
}

/// True if the name, or a component of it, is compared or reduced anywhere in the stage: then the text does
/// not show which values reach a subscript.
bool isGuarded(const Unit& unit, std::string_view name) {
    for (std::uint32_t at = 0; at < unit.view.size(); ++at) {
        if (unit.text(at) != name || unit.bodies.roles[at] == WordRole::member) continue;
        const std::uint32_t after = unit.text(at + 1) == "." ? at + 3 : at + 1;
        if (isComparison(unit.text(after)) || (at > 0 && isComparison(unit.text(at - 1)))) return true;
        const bool isCast = at >= 2 && unit.text(at - 1) == "(" &&
                            (unit.text(at - 2) == "int" || unit.text(at - 2) == "uint");
        if (isCast && (isComparison(unit.text(after + 1)) || (at > 2 && isComparison(unit.text(at - 3)))))
            return true;
    }
    return false;
}

// ---- Patches

void readsOfPatch(const Unit& unit, TranslatedProgram& result) {
    const bool isOwnGuarded = isGuarded(unit, "gl_InvocationID") || unit.isUsed("gl_PatchVerticesIn");
    const auto isInput = [&](std::uint32_t at) {
        if (unit.text(at) == "gl_in") return true;
        const Variable* found = unit.firstVariable(unit.text(at));
        return found != nullptr && found->storage == Storage::input && !found->patch && found->isArray();
    };
    for (std::uint32_t at = 0; at + 2 < unit.view.size(); ++at) {
        if (unit.bodies.roles[at] != WordRole::global || unit.text(at + 1) != "[" || !isInput(at)) continue;
        const std::uint32_t close = unit.bodies.matches[at + 1];
        if (close >= unit.view.size()) continue;
        const Range subscript{at + 2, close};
        long long index = -1;
        if (!integerValue(unit, subscript, index)) {
            const bool isOwn = close == at + 3 && unit.text(at + 2) == "gl_InvocationID";
            index = isOwn && !isOwnGuarded ? result.patchVertices - 1 : -1;
        }
        constexpr long long kMost = 1024;
        if (index < result.patchVerticesRead || index > kMost) continue;
        result.patchVerticesRead = static_cast<int>(index) + 1;
        result.patchReadPlace = unit.place(at);
        result.patchRead = std::string(unit.text(at)) + "[" + textOf(unit, subscript) + "]";
    }
}

// ---- Geometry

void readMostVertices(const Unit& unit, TranslatedProgram& result) {
    for (const Declaration& each : unit.syntax.declarations) {
        if (each.kind != DeclarationKind::layoutOnly || each.qualifiers.storage != Storage::output) continue;
        const LayoutItem* item = each.qualifiers.item("max_vertices");
        long long value = 0;
        constexpr long long kMost = 1 << 20;
        if (item == nullptr || !globalIntegerValue(unit, item->value, value) || value <= 0 || value > kMost)
            continue;
        result.maxVertices = static_cast<int>(value);
        result.maxVerticesPlace = unit.place(item->tokens.first);
    }
}

// ---- Invocations

void axesOf(const Unit& unit, TranslatedProgram& result) {
    for (const std::string_view name : {"gl_GlobalInvocationID", "gl_WorkGroupID"}) {
        const auto uses = unit.uses.find(name);
        if (uses == unit.uses.end()) continue;
        for (const std::uint32_t at : uses->second) {
            const std::string_view component = unit.text(at + 1) == "." ? unit.text(at + 2) : "xyz";
            constexpr std::string_view kNames = "xyzrgbstp";
            for (const char c : component)
                if (const std::size_t axis = kNames.find(c); axis != std::string_view::npos)
                    result.invocationAxes.at(axis % 3) = true;
        }
    }
}

// ---- Elements

/// Finds the subscripts of the last members of storage blocks.
class SubscriptSearch {
  public:
    explicit SubscriptSearch(const Unit& unit) : unit_(unit), search_(unit) {}

    std::vector<ElementSubscript> find() {
        std::vector<ElementSubscript> found;
        for (const Declaration& block : unit_.syntax.declarations) {
            if (block.kind != DeclarationKind::block || block.qualifiers.storage != Storage::buffer ||
                block.members.empty() || block.members.back().declarators.empty())
                continue;
            const bool isSingle = block.declarators.empty() || block.declarators.front().dimensions.empty();
            if (!isSingle) continue;
            const std::string_view array = unit_.text(block.members.back().declarators.back().name);
            const std::string_view instance =
                block.declarators.empty() ? std::string_view() : unit_.text(block.declarators.front().name);
            findOf(array, instance, found);
        }
        return found;
    }

  private:
    void findOf(std::string_view array, std::string_view instance, std::vector<ElementSubscript>& found) {
        constexpr std::size_t kMost = 64;
        for (std::uint32_t at = 0; at + 2 < unit_.view.size() && search_.spend(1); ++at) {
            if (unit_.text(at) != array || unit_.text(at + 1) != "[") continue;
            const bool isOfInstance = at >= 2 && unit_.text(at - 1) == "." && unit_.text(at - 2) == instance;
            if (instance.empty() ? unit_.bodies.roles[at] != WordRole::global : !isOfInstance) continue;
            const std::uint32_t close = unit_.bodies.matches.at(at + 1);
            if (close >= unit_.view.size() || found.size() == kMost) continue;
            ElementSubscript one{std::string(array), {}, 0, unit_.place(at)};
            const Range subscript{at + 2, close};
            if (integerValue(unit_, subscript, one.constant)) {
                found.push_back(std::move(one));
            } else if (one.number = numberIn(subscript); !one.number.empty()) {
                found.push_back(std::move(one));
            }
        }
    }

    /// The number of the invocation, vertex or instance that the range is; empty if it is another value or
    /// one that the stage limits.
    std::string numberIn(Range range) {
        const bool isCast = range.end > range.first + 3 && unit_.text(range.first + 1) == "(" &&
                            unit_.bodies.matches.at(range.first + 1) + 1 == range.end &&
                            (unit_.text(range.first) == "int" || unit_.text(range.first) == "uint");
        if (isCast) return numberIn({range.first + 2, range.end - 1});
        const std::string_view name = unit_.text(range.first);
        if (isGuarded(unit_, name)) return {};
        if (range.end == range.first + 1) {
            if (name == "gl_VertexID" || name == "gl_InstanceID" || name == "gl_LocalInvocationIndex")
                return std::string(name);
            const LocalVariable* kept =
                unit_.bodies.roles[range.first] == WordRole::local ? search_.keptLocal(range.first) : nullptr;
            return kept != nullptr ? numberIn(kept->initializer) : "";
        }
        const bool isComponent = range.end == range.first + 3 && unit_.text(range.first + 1) == ".";
        if (!isComponent ||
            (name != "gl_GlobalInvocationID" && name != "gl_WorkGroupID" && name != "gl_LocalInvocationID"))
            return {};
        const std::string_view component = unit_.text(range.first + 2);
        return component == "x" ? std::string(name) + ".x" : "";
    }

    const Unit& unit_;
    FormulaSearch search_;
};

}  // namespace

void collectReaches(ProgramUnits& program) {
    TranslatedProgram& result = *program.result;
    const Unit* control = program.find(Stage::tessControl);
    const Unit* evaluation = program.find(Stage::tessEvaluation);
    if (control != nullptr)
        readsOfPatch(*control, result);
    else if (evaluation != nullptr)
        readsOfPatch(*evaluation, result);
    if (const Unit* geometry = program.find(Stage::geometry)) readMostVertices(*geometry, result);
    if (const Unit* compute = program.find(Stage::compute)) axesOf(*compute, result);
}

std::vector<ElementSubscript> subscriptsOf(const Unit& unit) {
    return SubscriptSearch(unit).find();
}

// The uniforms that decide tessellation levels and nothing else. The search follows a value through the
// control stage, statement by statement, and gives up at every statement that it does not understand.

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
