#pragma once
// Private to this room: the messages of a plan, and what it remarks about draws and dispatches.

#include <bitset>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/raster_state.h"
#include "plan/frame_plan.h"
#include "plan/planned_programs.h"
#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

// Do the outputs of a fragment stage fit the targets of the pass?

/// Returns draw-E11 for each output whose kind (floating, signed or unsigned integer) differs from that of
/// the texels which it writes: OpenGL leaves the result undefined (GL 4.6, 17.4.4). A target without colour
/// writes does not count.
Diagnostics outputProblems(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass,
                           const ProgramInterface& interface);

/// The colour targets of the pass that the draw may write but its program has no output for: OpenGL leaves
/// undefined what it would write there (GL 4.6, 15.2.3).
std::bitset<base::kRasterTargets> targetsWithoutOutput(const scene::Draw& draw, const scene::Pass& pass,
                                                       const ProgramInterface& interface);

/// A target that has several layers or faces.
struct LayeredTarget {
    std::string name;
    int count = 0;
    bool isCube = false;
};
/// The first target of which the pass names no single layer or face, if that target has several. Nothing for
/// the window.
std::optional<LayeredTarget> layeredTarget(const scene::Scene& scene, const scene::Pass& pass);

/// A colour target in messages: "the window", "target 'ids' (line 4)".
std::string describeTarget(const scene::Scene& scene, const scene::Pass& pass, std::size_t target);

class DrawRemarks {
  public:
    /// All of them must outlive this. `clipsFromZero`: PlanOptions.
    DrawRemarks(const scene::Scene& scene, PlannedPrograms& programs, FramePlan& plan, bool clipsFromZero)
        : scene_(scene), programs_(programs), plan_(plan), clipsFromZero_(clipsFromZero) {}

    /// Adds the diagnostic to the plan unless an equal one at the same place exists.
    void report(const Diagnostic& diagnostic);
    /// Reports draw-W01 once per program: where the built-in program draws, and where the colour of a
    /// supplied fragment stage is a guess.
    void missingStage(const scene::Draw& draw, const ProgramInterface& interface);
    /// Reports draw-W02, W03, W05, W12, W15, W19 and W21, each only at the first draw that it applies to.
    void ofDraw(const scene::Draw& draw, PlannedProgramIndex index, const scene::Program* program,
                const Submission& submission, const std::vector<TextureUse>& uses);
    /// Reports draw-W12.
    void hazards(const std::string& word, const Place& place, PlannedProgramIndex index,
                 const std::vector<TextureUse>& uses);
    /// Reports draw-W02.
    void emptySlots(const Place& place, PlannedProgramIndex index, const std::vector<TextureUse>& uses);
    /// Reports draw-W10 for targets that the draw leaves as they are.
    void unwritten(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index,
                   const std::bitset<base::kRasterTargets>& unwritten);
    /// Reports draw-W14 for a draw that reaches the first of several layers only.
    void layers(const scene::Draw& draw, const scene::Pass& pass, PlannedProgramIndex index);

  private:
    void warnOnce(const Place& place, PlannedProgramIndex index, const char* id, const std::string& text,
                  std::string subject = {}, std::string suggestion = {});
    /// The hint for an input that nothing feeds: an attribute of the draw with a name that is near and that
    /// no input has, otherwise a well-known name.
    struct InputHint {
        std::string text, suggestion;
    };
    [[nodiscard]] InputHint hintForInput(const scene::Draw& draw, const ProgramInterface& interface,
                                         const ActiveInput& input) const;
    void reportUnknownInputs(const scene::Draw& draw, PlannedProgramIndex index);
    /// Reports draw-W19 for a projection whose depth buffer tells little apart, and for matrices that a
    /// shader multiplies though 32-bit floats lose the place of what is drawn; draw-W21 for reversed depth
    /// that is no more exact than usual.
    void reportPrecision(const scene::Draw& draw, PlannedProgramIndex index);
    /// Reports draw-W15 for attributes of the draw that no input has and whose names are near that of an
    /// input without one.
    void reportUnreadAttributes(const scene::Draw& draw, PlannedProgramIndex index);
    void reportIgnoredPointSize(const scene::Draw& draw, PlannedProgramIndex index,
                                const scene::Program& program);

    const scene::Scene& scene_;
    PlannedPrograms& programs_;
    FramePlan& plan_;
    bool clipsFromZero_;
    std::set<scene::ProgramIndex> incomplete_;  ///< programs of draw-W01
    std::set<std::tuple<scene::ProgramIndex, std::string, std::string>> remarks_;
    std::set<std::tuple<std::string, std::string, std::string, int, int>> reported_;
};

}  // namespace glibra::plan
