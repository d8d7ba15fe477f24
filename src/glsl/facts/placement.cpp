// Finds out whether a vertex stage only applies the model-view-projection to its vertices. Then the mesh and
// the matrices alone tell where it can appear in the picture.

#include <algorithm>
#include <array>
#include <optional>

#include "glsl/facts/facts.h"
#include "glsl/parse/usage.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

/// The meaning of an expression. `point`, `eyePoint` and `clipPoint` begin with vec4(vertex.xyz, 1) in place
/// of the vertex.
enum class Meaning {
    vertex,
    world,
    eye,
    clip,
    point,
    worldPoint,
    eyePoint,
    clipPoint,
    place,  ///< vertex.xyz; before it, vectors of four components
    other,
    model,
    view,
    viewProjection,
    modelView,
    projection,
    modelViewProjection
};

Meaning product(Meaning left, Meaning right) {
    using enum Meaning;
    struct Row {
        Meaning left, right, result;
    };
    static constexpr std::array kProducts = std::to_array<Row>({{model, vertex, world},
                                                                {model, point, worldPoint},
                                                                {view, world, eye},
                                                                {view, worldPoint, eyePoint},
                                                                {view, model, modelView},
                                                                {projection, view, viewProjection},
                                                                {viewProjection, world, clip},
                                                                {viewProjection, worldPoint, clipPoint},
                                                                {viewProjection, model, modelViewProjection},
                                                                {modelView, vertex, eye},
                                                                {modelView, point, eyePoint},
                                                                {projection, eye, clip},
                                                                {projection, eyePoint, clipPoint},
                                                                {projection, modelView, modelViewProjection},
                                                                {modelViewProjection, vertex, clip},
                                                                {modelViewProjection, point, clipPoint}});
    for (const Row& each : kProducts)
        if (each.left == left && each.right == right) return each.result;
    return other;
}

class PlacementSearch {
  public:
    explicit PlacementSearch(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] const std::vector<std::string>& wellKnownNames() const { return wellKnownNames_; }

    Placement find() {
        switch (meaning(positionInMain())) {
            case Meaning::clip:
                return Placement::vertex;
            case Meaning::clipPoint:
                return Placement::point;
            default:
                return Placement::unknown;
        }
    }

  private:
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }

    /// The right side of the only assignment to gl_Position, if main always executes it; or kNone.
    std::uint32_t positionInMain() {
        const auto writes = unit_.writes.find("gl_Position");
        if (writes == unit_.writes.end() || writes->second.size() != 1) return kNone;
        const std::uint32_t at = writes->second.front(), name = unit_.bodies.nodeOf[at];
        const std::optional<Range> main = bodyOfMain(unit_);
        if (name == kNone || !main || !isAlwaysExecuted(unit_, *main, at)) return kNone;
        body_ = *main;
        const std::uint32_t assignment = node(name).parent;
        return assignment != kNone && unit_.text(at + 1) == "=" ? node(assignment).lastChild : kNone;
    }

    /// The meaning of factors joined by '*'; `other` for all other expressions.
    Meaning meaning(std::uint32_t id) {
        constexpr int kDeepest = 16;
        if (id == kNone || depth_ >= kDeepest) return Meaning::other;
        const Node& it = node(id);
        ++depth_;
        Meaning all = Meaning::other;
        if (it.kind == NodeKind::name) all = name(it.token);
        if (it.kind == NodeKind::group) all = meaning(it.child);
        if (it.kind == NodeKind::call) all = call(it);
        if (it.kind == NodeKind::chain)
            for (const std::uint32_t each : unit_.bodies.children(id)) {
                const bool isFirst = each == it.child;
                if (!isFirst && unit_.text(node(each).first - 1) != "*") all = Meaning::other;
                all = isFirst ? meaning(each) : product(all, meaning(each));
            }
        --depth_;
        return all;
    }

    Meaning call(const Node& call) {
        const std::string_view function = unit_.text(call.token);
        if (unit_.isUserName(function)) return Meaning::other;
        if (function == "ftransform" && call.child == kNone &&
            unit_.bodies.roles[call.token] == WordRole::global)
            return Meaning::clip;
        return function == "vec4" && call.child != kNone ? constructed(call) : Meaning::other;
    }

    /// The meaning of vec4(vertex), vec4(vertex.xyz, 1.) or, of a vertex of three components,
    /// vec4(vertex, 1.).
    Meaning constructed(const Node& call) {
        using enum Meaning;
        const Node& first = node(call.child);
        const bool isAlone = first.next == kNone;
        const bool isPart = !isAlone && first.kind == NodeKind::member && unit_.text(first.token) == "xyz";
        const Meaning whole = meaning(isPart ? first.child : call.child);
        if (isAlone) return isVector(whole) ? whole : other;
        const bool hasOne = first.next == call.lastChild && isLiteralOne(unit_.text(call.end - 2)) &&
                            node(first.next).kind == NodeKind::number;
        const bool hasThree = isPart ? whole == vertex || whole == point : whole == place;
        return hasOne && hasThree ? point : other;
    }

    static bool isVector(Meaning meaning) { return meaning < Meaning::place; }

    Meaning name(std::uint32_t at) {
        using enum Meaning;
        if (unit_.bodies.roles[at] == WordRole::local) return local(at);
        const std::string_view name = unit_.text(at);
        if (unit_.bodies.roles[at] != WordRole::global || unit_.isWritten(name) ||
            unit_.macros.contains(name))
            return other;
        const Variable* found = unit_.firstVariable(name);
        if (found == nullptr) {
            if (unit_.isDeclared(name)) return other;
            return name == "aVertex" || name == "gl_Vertex" ? vertex : matrix(name);
        }
        if (found->isArray() || name.starts_with("gl_")) return other;
        if (found->storage == Storage::input && (name == "aVertex" || isWellKnownPosition(*found)))
            return found->type == "vec4"                        ? vertex
                   : found->type == "vec3" && name != "aVertex" ? place
                                                                : other;
        return found->storage == Storage::uniform && found->type == "mat4" ? matrix(name) : other;
    }

    [[nodiscard]] bool isWellKnownPosition(const Variable& input) {
        const bool isKnown =
            unit_.request->suppliesMatrices && wellKnownAttribute(input.name, input.type) == "position";
        if (isKnown) wellKnownNames_.push_back(input.name);
        return isKnown;
    }

    /// The meaning of a matrix that the runtime supplies by its name.
    [[nodiscard]] Meaning matrix(std::string_view name) {
        using enum Meaning;
        std::optional<Builtin> value;
        if (const BuiltinUniform* row = findBuiltinUniform(name)) {
            value = row->value;
        } else if (unit_.request->suppliesMatrices && !hasInitializer(name)) {
            value = wellKnownUniform(name, "mat4");
            if (value) wellKnownNames_.emplace_back(name);
        }
        if (!value) return other;
        switch (*value) {
            case Builtin::model:
                return model;
            case Builtin::view:
                return view;
            case Builtin::viewProjection:
                return viewProjection;
            case Builtin::modelView:
                return modelView;
            case Builtin::projection:
                return projection;
            case Builtin::modelViewProjection:
                return modelViewProjection;
            default:
                return other;
        }
    }

    [[nodiscard]] bool hasInitializer(std::string_view name) const {
        const Variable* found = unit_.firstVariable(name);
        return found != nullptr && !unit_.syntax.declarations[found->declaration]
                                        .declarators[found->declarator]
                                        .initializer.empty();
    }

    /// The meaning of a variable of main that keeps its initial value.
    Meaning local(std::uint32_t at) {
        const std::string_view text = unit_.text(at);
        const LocalVariable* declared = unit_.onlyLocal(text);
        if (declared == nullptr || declared->isParameter || declared->initializer.empty() ||
            !body_.contains(declared->name) || declared->name > at || hasOutputs())
            return Meaning::other;
        for (std::uint32_t i = body_.first; i < body_.end; ++i)
            if (unit_.text(i) == text && unit_.bodies.roles[i] == WordRole::local && isWrittenAt(unit_, i))
                return Meaning::other;
        const Meaning initial = meaning(declared->value);
        const std::string_view wanted = isVector(initial) ? "vec4" : "mat4";
        return declared->typeWord == wanted && declared->type.arrayDepth == 0 ? initial : Meaning::other;
    }

    /// True if some function writes to its arguments, so that local variables can change without an
    /// assignment.
    [[nodiscard]] bool hasOutputs() const {
        const auto writes = [](const Parameter& each) {
            return each.qualifiers.storage == Storage::output ||
                   each.qualifiers.storage == Storage::inputOutput;
        };
        return unit_.isUsed("modf") || unit_.isUsed("frexp") ||
               std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
                   return std::ranges::any_of(each.parameters, writes);
               });
    }

    const Unit& unit_;
    Range body_;
    int depth_ = 0;
    std::vector<std::string> wellKnownNames_;
};

/// True if the stage may change anything except the picture, or chooses the picture's layer.
bool hasOtherEffects(const Unit& unit) {
    return hasWritableStorage(unit) || unit.isUsed("gl_Layer") || unit.isUsed("gl_ViewportIndex") ||
           std::ranges::any_of(unit.variables, [](const Variable& each) {
               return each.storage == Storage::buffer || each.type == "atomic_uint" ||
                      each.type.find("image") != std::string::npos;
           });
}

}  // namespace

void findPlacement(const ProgramUnits& program) {
    const auto& units = program.units;
    const bool isPlain = !units.empty() && units[0].stage == Stage::vertex &&
                         (units.size() == 1 || (units.size() == 2 && units[1].stage == Stage::fragment));
    if (!isPlain || std::ranges::any_of(units, hasOtherEffects)) return;
    PlacementSearch search(units[0]);
    program.result->placement = search.find();
    program.result->placementNames = search.wellKnownNames();
}

}  // namespace glibra::glsl
