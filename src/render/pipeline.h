#pragma once
// The one owner of a scene on its way from text to pixels. SceneState adds tiles and readback to it, the
// window adds knobs, cameras and edits.

#include <glibra/render.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "plan/planner.h"
#include "plan/still.h"
#include "render/draw/axes.h"
#include "render/draw/frame.h"
#include "render/draw/view_matrices.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/scene_file.h"
#include "render/simulation/simulation.h"
#include "render/stats.h"
#include "scene/interpret.h"
#include "scene/scene.h"

namespace glibra::render {

/// What a plan must know of the driver.
plan::PlanOptions planOptionsOf(const gpu::Capabilities& driver);

/// Members refer to members above them, so a pipeline never moves. Nothing here reads the scene's text again:
/// drawing at another time, in another size or with other values costs what differs.
struct Pipeline {
    struct Setup {
        bool isTiled = false;           ///< programs can draw a part of a larger picture
        bool hasProbes = false;         ///< shares parts with pictures that answer questions
        SharedParts* shared = nullptr;  ///< parts of other scenes; it must outlive this
        bool watchesLoops = false;      ///< frames may record loops that the driver ends
    };
    /// `stats` is of loading the scene and must outlive this. Needs no GL.
    Pipeline(gpu::Context& usedContext, RenderOptions usedOptions, InterpretedScene interpreted, Stats& stats,
             const Setup& setup);
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;

    gpu::Context& context;
    Stats& loadStats;
    RenderOptions options;
    bool changesWithTime;                           ///< as first interpreted
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`
    scene::Scene scene;
    std::unique_ptr<SharedParts> ownParts;  ///< Setup::hasProbes
    SharedParts* parts;                     ///< `ownParts`, or what other scenes share, or null
    ProgramLibrary programs;
    DeviceScene device;
    plan::FramePlan plan;
    std::optional<Simulation> simulation;  ///< of a scene with Once or Step
    std::optional<FrameDrawer> drawer;
    std::optional<Axes> axes;
    ViewMatrices view;
    double eyeDistance = 0;  ///< by which the view policy has moved the eye back
    /// Writes values that the scene does not have into each new plan. May be empty.
    std::function<void(plan::FramePlan&)> adjustPlan;

    /// The rounds after which the driver ends a loop, measured once.
    int loopLimit();
    /// Makes what records the loops that the driver ends (Frame::recordsLoops), if it ends any. Call it
    /// before the first frame of a plan.
    void recordLoops(const plan::FramePlan& of);
    /// Begins or ends what Setup::watchesLoops says. What was reported before is reported again.
    void watchLoops(bool on);
    /// True if the next frame records: the first with the values of its uniforms, the second, the fourth and
    /// so on, since buffers and time may lengthen loops.
    [[nodiscard]] bool recordsLoops() const;
    /// The loops that the driver has ended since the last call: draw-W08.
    Diagnostics takeCutLoops();
    /// Why nothing of a draw can be seen, or an empty text.
    using OutOfSight = std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)>;
    /// The plan of that list. Without `outOfSight` all draws may be seen.
    [[nodiscard]] plan::FramePlan planList(const scene::NodeList& nodes, const plan::PlanOptions& planOptions,
                                           const OutOfSight& outOfSight = {});
    /// True if the scene has Once or Step blocks. planSimulation() then reports what plan::reportNames()
    /// finds in all lists, so the plan of the frame must not (PlanOptions::reportsNames).
    [[nodiscard]] bool hasBlocks() const { return !scene.once.empty() || !scene.steps.empty(); }
    /// Plans the Once and Step blocks, if there are any, or checks the frame's plan against them.
    /// `framesDiffer`: Simulation::plan.
    Diagnostics planSimulation(const plan::PlanOptions& planOptions, bool framesDiffer);
    /// Of the frame, then of the Once and Step blocks.
    [[nodiscard]] std::vector<const plan::FramePlan*> plans() const;
    /// For a new `plan`. Draws whose program cannot be used show their shapes in one colour.
    void makeDrawer(Stats& stats);
    Diagnostics makeAxes();

    /// Interprets the scene for other inputs, if it depends on what differs. True: `scene` is another one,
    /// and the caller makes its plan. The simulation is gone if it must be planned again.
    bool interpret(const scene::FrameInputs& wanted, Diagnostics& diagnostics, Stats& stats);
    /// Finds `eyeDistance` for pictures of this aspect ratio.
    void placeEye(double aspect, Diagnostics& diagnostics, Stats& stats);
    /// Makes `view` that of the scene, with the viewer's transforms.
    void lookFrom(const ViewState& state);
    /// lookFrom() makes `view` again, whatever it was.
    void forgetView() { isViewSet_ = false; }

    /// Changes literals in all plans (Simulation::changeValues).
    void changeValues(const std::function<std::vector<plan::PlannedProgramIndex>(plan::FramePlan&)>& change);

    /// What of the next frame, of this size, is the same as in the frame that was drawn last. A pass that the
    /// viewer's transforms move is the same only while they stay.
    [[nodiscard]] plan::StillNodes stillNodes(int width, int height) const;
    /// Call it after each frame, with what drawing it reported.
    void noteDrawn(int width, int height, const Diagnostics& diagnostics);
    /// Every node of the next frame is drawn.
    void forgetDrawn();

  private:
    /// What was drawn last, if `scene` or `plan` has changed since.
    struct Drawn {
        std::optional<scene::Scene> scene;  ///< empty: only the plan has changed
        plan::FramePlan plan;
    };
    /// Keeps what was drawn. Call it before the values in `plan` change, or before `scene` and `plan`
    /// (`ofScene`) are replaced.
    void noteChange(bool ofScene);

    bool watchesLoops_;
    std::optional<int> loopLimit_;
    std::uint64_t frames_ = 0;         ///< that were drawn with these values
    std::optional<double> eyeAspect_;  ///< that eyeDistance was computed for
    bool isViewSet_ = false;           ///< `view` was made by lookFrom() for this scene
    double setEyeDistance_ = 0;        ///< the eyeDistance in `view`
    std::optional<Drawn> drawnBefore_;
    bool isDrawn_ = false;  ///< the last frame was drawn whole, and nothing else since
    ViewState drawnView_;
    int drawnWidth_ = 0, drawnHeight_ = 0;
    std::int64_t drawnChanges_ = 0;  ///< Simulation::changes() of that frame
};

}  // namespace glibra::render
