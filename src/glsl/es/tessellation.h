#pragma once
// WebGL 2 has no tessellation stages: their work is done by the vertex stage.

#include <string>

#include "base/tessellation_layout.h"
#include "glsl/es/parts.h"
#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The control and evaluation stages of a program as parts of its vertex stage. An instance is a patch. For
/// each vertex that the patch becomes, the vertex stage runs for all corners of the patch, the control stage
/// for all its invocations, and the evaluation stage once. Whoever draws gives the coordinates of the
/// vertices, which it knows after it has measured the levels (ExpandedGeometry).
class TessellationInVertex {
  public:
    /// All were parsed. Call prepare() before they are adapted to GLSL ES. `control` may be null. `corners`:
    /// vertices of a patch.
    TessellationInVertex(Unit& vertex, Unit* control, Unit& evaluation, int corners,
                         const TranslatedProgram& program)
        : vertex_(vertex),
          control_(control),
          evaluation_(evaluation),
          corners_(corners),
          points_(program.patchVertices),
          inputs_(vertex, "glibra_v", "glibra_inputs", corners),
          primitives_(evaluation, "glibra_e", "glibra_corners", 0) {}

    /// Rewrites the stages. Returns what cannot be expressed, as a text, or nothing. `geometry`: corners that
    /// a geometry stage reads of what they deliver; 0: there is none.
    std::string prepare(int geometry);
    [[nodiscard]] const base::TessellationLayout& layout() const { return layout_; }
    [[nodiscard]] const CornerStage& corners() const { return inputs_; }
    /// ExpandedGeometry::areInSequence: vertex data come with instances.
    [[nodiscard]] bool areInSequence() const { return !inputs_.hasInputs(); }
    /// The evaluation stage before a geometry stage.
    CornerStage& primitives() { return primitives_; }
    [[nodiscard]] const CornerStage& primitives() const { return primitives_; }

    [[nodiscard]] BlockPlace inputOf(Stage stage);
    [[nodiscard]] BlockPlace outputOf(Stage stage, bool isOfPatch) const;

    /// Functions and variables that follow the text of the stages.
    [[nodiscard]] std::string functions() const;
    /// The first statements of main, up to the evaluation stage.
    [[nodiscard]] std::string statements() const;
    /// Sets what the evaluation stage gets for a vertex of the patch, an expression. That which is drawn is
    /// "glibra_at".
    [[nodiscard]] std::string coordinate(const std::string& vertex) const;

  private:
    void readLayout();
    std::string prepareControl();
    std::string takeOutputs();

    Unit& vertex_;
    Unit* control_;
    Unit& evaluation_;
    int corners_, points_;
    bool hasBarrier_ = false;
    base::TessellationLayout layout_;
    CornerStage inputs_, primitives_;
};

}  // namespace glibra::glsl
