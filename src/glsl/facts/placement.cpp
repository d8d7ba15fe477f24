// Finds out whether a vertex stage only applies the model-view-projection to its vertices. Then the mesh and
// the matrices alone tell where it can appear in the picture.

#include <algorithm>
#include <array>
#include <optional>

#include "glsl/facts/facts.h"
#include "glsl/parse/straight_line.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

/// The meaning of an expression. `point`, `eyePoint` and `clipPoint` begin with vec4(vertex.xyz, 1) in place
/// of the vertex.
enum class Meaning {
    other,
    vertex,
    eye,
    clip,
    point,
    eyePoint,
    clipPoint,
    modelView,
    projection,
    modelViewProjection
};

Meaning product(Meaning left, Meaning right) {
    using enum Meaning;
    struct Row {
        Meaning left, right, result;
    };
    static constexpr std::array kProducts = std::to_array<Row>({{modelView, vertex, eye},
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

    Placement find() {
        const std::optional<Range> value = positionInMain();
        if (!value) return Placement::unknown;
        switch (meaning(*value)) {
            case Meaning::clip:
                return Placement::vertex;
            case Meaning::clipPoint:
                return Placement::point;
            default:
                return Placement::unknown;
        }
    }

  private:
    /// The right side of the only assignment to gl_Position, if main always executes it.
    std::optional<Range> positionInMain() {
        const auto writes = unit_.writes.find("gl_Position");
        if (writes == unit_.writes.end() || writes->second.size() != 1) return std::nullopt;
        const std::uint32_t at = writes->second.front();
        const std::optional<Range> main = bodyOfMain(unit_);
        if (!main || !isAlwaysExecuted(unit_, *main, at)) return std::nullopt;
        body_ = *main;
        const std::uint32_t end = endOfStatement(at);
        if (unit_.text(at + 1) != "=" || end == kNone) return std::nullopt;
        return Range{at + 2, end};
    }

    [[nodiscard]] std::uint32_t endOfStatement(std::uint32_t at) const {
        for (std::uint32_t i = at; i < body_.end; ++i)
            if (unit_.text(i) == ";") return i;
        return kNone;
    }

    /// The meaning of factors joined by '*'; `other` for all other expressions.
    Meaning meaning(Range range) {
        constexpr int kDeepest = 16;
        if (range.empty() || depth_ >= kDeepest) return Meaning::other;
        ++depth_;
        Meaning all = Meaning::other;
        std::uint32_t at = range.first;
        for (bool isFirst = true; at < range.end; isFirst = false) {
            if (!isFirst && unit_.text(at++) != "*") {
                all = Meaning::other;
                break;
            }
            const Meaning one = factor(at, range.end);
            all = isFirst ? one : product(all, one);
            if (all == Meaning::other) break;
        }
        --depth_;
        return all;
    }

    /// The meaning of the factor at `at`, which moves to the index after it.
    Meaning factor(std::uint32_t& at, std::uint32_t end) {
        const std::string_view text = unit_.text(at);
        const bool opens = text == "(";
        const std::uint32_t open = opens ? at : at + 1;
        if (!opens && unit_.text(open) != "(") return name(at++);
        const std::uint32_t close = unit_.bodies.matches[open];
        if (close >= end) return Meaning::other;
        const Range inside{open + 1, close};
        const std::uint32_t word = at;
        at = close + 1;
        if (opens) return meaning(inside);
        if (unit_.isUserName(text)) return Meaning::other;
        if (text == "ftransform" && inside.empty() && unit_.bodies.roles[word] == WordRole::global)
            return Meaning::clip;
        return text == "vec4" ? constructed(inside) : Meaning::other;
    }

    /// The meaning of vec4(vertex) or vec4(vertex.xyz, 1.).
    Meaning constructed(Range inside) {
        const bool isPoint = inside.end - inside.first == 5 && unit_.text(inside.first + 1) == "." &&
                             unit_.text(inside.first + 2) == "xyz" && unit_.text(inside.first + 3) == "," &&
                             isLiteralOne(unit_.text(inside.first + 4));
        if (isPoint) {
            const Meaning whole = name(inside.first);
            return whole == Meaning::vertex || whole == Meaning::point ? Meaning::point : Meaning::other;
        }
        const Meaning whole = meaning(inside);
        return isVector(whole) ? whole : Meaning::other;
    }

    static bool isVector(Meaning meaning) {
        return meaning != Meaning::modelView && meaning != Meaning::projection &&
               meaning != Meaning::modelViewProjection;
    }

    Meaning name(std::uint32_t at) {
        if (unit_.bodies.roles[at] == WordRole::local) return local(at);
        if (unit_.bodies.roles[at] != WordRole::global) return Meaning::other;
        struct Row {
            std::string_view name;
            Meaning meaning;
        };
        static constexpr std::array kNames =
            std::to_array<Row>({{"aVertex", Meaning::vertex},
                                {"gl_Vertex", Meaning::vertex},
                                {"uModelViewMatrix", Meaning::modelView},
                                {"gl_ModelViewMatrix", Meaning::modelView},
                                {"uProjectionMatrix", Meaning::projection},
                                {"gl_ProjectionMatrix", Meaning::projection},
                                {"uModelViewProjectionMatrix", Meaning::modelViewProjection},
                                {"gl_ModelViewProjectionMatrix", Meaning::modelViewProjection}});
        for (const Row& each : kNames)
            if (each.name == unit_.text(at))
                return isSupplied(each.name, each.meaning == Meaning::vertex) ? each.meaning : Meaning::other;
        return Meaning::other;
    }

    /// True if the name has its built-in meaning here.
    [[nodiscard]] bool isSupplied(std::string_view name, bool isInput) const {
        if (unit_.isWritten(name) || unit_.macros.contains(name)) return false;
        if (!unit_.isDeclared(name)) return true;
        const Variable* found = unit_.firstVariable(name);
        return !name.starts_with("gl_") && found != nullptr && !found->isArray() &&
               found->storage == (isInput ? Storage::input : Storage::uniform) &&
               found->type == (isInput ? "vec4" : "mat4");
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
        const Meaning initial = meaning(declared->initializer);
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

Placement findPlacement(const ProgramUnits& program) {
    const auto& units = program.units;
    const bool isPlain = !units.empty() && units[0].stage == Stage::vertex &&
                         (units.size() == 1 || (units.size() == 2 && units[1].stage == Stage::fragment));
    if (!isPlain || std::ranges::any_of(units, hasOtherEffects)) return Placement::unknown;
    return PlacementSearch(units[0]).find();
}

}  // namespace glibra::glsl
