#pragma once
// Stages that WebGL 2 does not have become parts of the vertex stage. This is what all of them need: a stage
// whose work is done once for each corner of what the next one reads, and the variables between the two.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/tessellation_layout.h"
#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// How an input of the vertex stage is named for a corner; ExpandedGeometry says how they are placed.
inline constexpr const char* kCornerInput = "glibra_Corner";

/// How the emitted text spells a name of the stage.
std::string emittedName(const Unit& unit, const std::string& name);
/// It is a variable of the stage from now on.
void makePlain(Variable& variable);
/// The same, as an array.
void makeArray(Variable& variable, int size);
/// The output of `from` that an input of the next stage reads: at the same location or of the same name. Null
/// if there is none.
Variable* outputFor(Unit& from, const Variable& input);
/// Removes the uniforms, blocks and structures that an earlier stage declares, too.
void removeTwins(Unit& unit, const Unit& earlier);
/// Gives all names of the file but those of uniforms a prefix, and an underscore.
void prefixNames(Unit& unit, std::string_view prefix);
/// Replaces .gl_Position and .gl_PointSize by the members of glibra_Corner.
void renameCornerMembers(Unit& unit);

/// Where the members of a block between two stages stand once both are parts of the vertex stage.
struct BlockPlace {
    std::string prefix;      ///< before "BLOCK_MEMBER"
    std::string sizes{};     ///< "[3]": an array in place of an array of blocks
    bool isDeclared = true;  ///< by this stage; false: by the one before it
    std::function<void(const std::string& member)> note{};  ///< gets "BLOCK_MEMBER"
};

/// A stage that runs for each corner of a patch or of a primitive.
class CornerStage {
  public:
    /// `prefix`: of the stage's names. `array`: of the corners, which the next stage reads as gl_in.
    CornerStage(Unit& unit, std::string prefix, std::string array, int corners)
        : unit_(&unit), prefix_(std::move(prefix)), array_(std::move(array)), corners_(corners) {}

    /// Renames what the stage declares. `instance`: what gl_InstanceID is written as.
    void prepare(std::string_view instance);
    /// The inputs of a vertex stage become one input for each corner, or are fetched from a texture.
    void spreadInputs();
    /// The inputs of `next` become arrays of what this stage delivers. False if it has some that this stage
    /// does not deliver.
    bool deliverTo(Unit& next);
    /// For the members of blocks that `next` reads and this stage delivers.
    void pass(const std::string& from, const std::string& to) { passed_.push_back({from, to}); }
    [[nodiscard]] BlockPlace output() const { return {prefix_ + "_"}; }
    [[nodiscard]] BlockPlace inputOfNext(const std::string& prefix);

    /// Statements that run the stage for a corner. `before`: what it needs.
    [[nodiscard]] std::string run(int corner, const std::string& before) const;
    [[nodiscard]] bool hasInputs() const { return !attributes_.empty(); }
    /// Those that do not fit into attributes.
    [[nodiscard]] const std::vector<ExpandedGeometry::Fetched>& fetched() const { return fetched_; }

  private:
    Unit* unit_;
    std::string prefix_, array_;
    int corners_;
    std::vector<std::string> attributes_;
    std::vector<ExpandedGeometry::Fetched> fetched_;
    std::vector<std::pair<std::string, std::string>>
        passed_;  ///< a variable here, an array of the next stage
};

// ---- Geometry
// WebGL 2 has no geometry stage: its work is done by the vertex stage.

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

// ---- Tessellation
// WebGL 2 has no tessellation stages: their work is done by the vertex stage.

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
