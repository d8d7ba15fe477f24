#pragma once
// WebGL 2 has no geometry stage: its work is done by the vertex stage.

#include <string>
#include <utility>
#include <vector>

#include "glsl/es/parts.h"
#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Corners of a primitive that a geometry stage takes, by the word of its layout; 0: no such word.
int cornersOfInput(std::string_view primitive);

/// The geometry stage of a program as a part of its vertex stage. For each vertex that the geometry stage may
/// deliver, the stage before it runs for all corners of a primitive, then the geometry stage, and what that
/// emits in the place of the vertex is kept. Primitives are numbered in the order in which they are emitted;
/// those that are not emitted lie outside of the picture.
class GeometryInVertex {
  public:
    /// `corners`: the stage before it. All were parsed. Call prepare() before they are adapted to GLSL ES.
    /// `fragment` may be null.
    GeometryInVertex(CornerStage& corners, Unit& geometry, Unit* fragment, const TranslatedProgram& program)
        : corners_(corners), geometry_(geometry), fragment_(fragment), program_(program) {}

    /// Rewrites the stage. `primitive`: what gl_PrimitiveIDIn is written as. `mayMeasure`: each instance is
    /// one primitive, and may be asked how many vertices it emits. Returns what cannot be expressed, as a
    /// text, or nothing.
    std::string prepare(const std::string& primitive, bool mayMeasure);
    /// Another output, such as the variable in place of a member of a block.
    void keep(std::string type, std::string name, std::string sizes = {}) {
        blockOutputs_.push_back({std::move(type), std::move(name), std::move(sizes)});
    }
    /// After that, and after the outputs were connected to the fragment stage: the functions that follow the
    /// stage's text.
    [[nodiscard]] std::string functions() const;
    /// The statements of main that follow the runs of the corners. `vertex`: the number of the vertex to
    /// deliver for this primitive.
    [[nodiscard]] std::string statements(const std::string& vertex) const;
    /// Of a primitive that the geometry stage takes.
    [[nodiscard]] ExpandedGeometry expansion() const;

  private:
    /// What is kept of a vertex that is emitted.
    struct Kept {
        std::string type, name, sizes;
    };
    [[nodiscard]] std::vector<Kept> kept() const;
    [[nodiscard]] int cornersOfOutput() const;
    /// True if the program can tell how many vertices the stage emits (ExpandedGeometry::mostEmitted).
    [[nodiscard]] bool isMeasured() const;
    /// How many primitives an invocation delivers at most.
    [[nodiscard]] int most() const;

    CornerStage& corners_;
    Unit& geometry_;
    Unit* fragment_;
    const TranslatedProgram& program_;
    int invocations_ = 1;
    bool isMeasured_ = false;  ///< isMeasured(), as far as the stage itself is asked
    std::vector<Kept> blockOutputs_;
};

}  // namespace glibra::glsl
