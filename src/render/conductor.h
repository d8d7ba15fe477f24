#pragma once
// The one owner of a scene on its way from text to pixels, and of the order of a frame: the scene is
// interpreted, planned, prepared on the device, simulated up to the frame's time, and drawn. SceneState takes
// pictures from it, LiveState shows it in a window.

#include <glibra/render.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/framebuffer.h"
#include "plan/needs.h"
#include "plan/planner.h"
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

/// What becomes of a picture that errors have cost something.
enum class OnError {
    stop,     ///< it is not drawn
    mark,     ///< what is left is drawn and marked, unless an error is in a Once or Step block
    leaveOut  ///< what is left is drawn, as in a window
};

/// What errors have cost so far.
enum class Condition {
    whole,         ///< nothing, or nothing that OnError takes into account
    incomplete,    ///< a part of the picture (OnError::mark), for good
    withoutSteps,  ///< the Once and Step blocks, which do not run (OnError::leaveOut)
    stopped        ///< all of it, until another moment is planned
};

/// Why nothing of a draw can be seen, or an empty text.
using OutOfSight = std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)>;

/// What is asked of a plan.
struct PlanRequest {
    plan::PlanOptions options;
    OutOfSight outOfSight{};   ///< empty: all draws of the frame may be seen
    bool framesDiffer = true;  ///< Simulation::plan
};

/// What the owner of a conductor decides. Functions may be empty.
struct Direction {
    bool isTiled = false;           ///< programs can draw a part of a larger picture
    bool hasProbes = false;         ///< shares parts with pictures that answer questions
    SharedParts* shared = nullptr;  ///< parts of other scenes; it must outlive the conductor
    bool watchesLoops = false;      ///< frames may record loops that the driver ends
    OnError onError = OnError::stop;
    /// Called when the scene is that of another moment, before it is planned.
    std::function<void()> interpreted{};
    /// What is asked of each plan. No value if an option names what the scene does not have.
    std::function<Result<PlanRequest>()> request{};
    /// Writes values that the scene does not have into each new plan.
    std::function<void(plan::FramePlan&)> adjustPlan{};
    /// Called with each plan of the frame; `isFirst`: there was none before.
    std::function<Diagnostics(bool isFirst)> planned{};
    /// Called with the first plans of the blocks.
    std::function<void()> simulationPlanned{};
    /// Makes what the owner needs of meshes, before the plan is on the device.
    std::function<Diagnostics()> measure{};
    /// Sets the options of each new drawer.
    std::function<void(FrameDrawer&)> equip{};
    Stats* drawStats = nullptr;  ///< of what is drawn; null: those of loading
};

/// What is drawn of a frame.
struct Shot {
    int width = 1, height = 1;  ///< of the whole picture
    Tile tile;                  ///< the part that is drawn
    bool isFirst = true;        ///< no other part has been drawn
    bool axes = false;
};

/// Members refer to members above them, so a conductor never moves. Nothing here reads the scene's text
/// again: drawing at another time, in another size or with other values costs what differs.
struct Conductor {
    /// `stats` is of loading the scene and must outlive this. Needs no GL.
    Conductor(gpu::Context& usedContext, RenderOptions usedOptions, InterpretedScene interpreted,
              Stats& stats, Direction given);
    Conductor(const Conductor&) = delete;
    Conductor& operator=(const Conductor&) = delete;

    gpu::Context& context;
    Stats& loadStats;
    RenderOptions options;
    bool changesWithTime;                           ///< as first interpreted
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`
    scene::Scene scene;
    std::unique_ptr<SharedParts> ownParts;  ///< Direction::hasProbes
    SharedParts* parts;                     ///< `ownParts`, or what other scenes share, or null
    ProgramLibrary programs;
    DeviceScene device;
    plan::FramePlan plan;
    std::optional<Simulation> simulation;  ///< of a scene with Once or Step
    std::optional<FrameDrawer> drawer;
    std::optional<Axes> axes;
    ViewMatrices view;
    double eyeDistance = 0;  ///< by which the view policy has moved the eye back
    Condition condition = Condition::whole;

    // The order of a frame.
    /// Interprets the scene for other inputs, if it depends on what differs, plans it and makes its drawer.
    /// Returns true if the plan is a new one.
    bool moveTo(const scene::FrameInputs& wanted, Diagnostics& diagnostics, Stats& stats);
    /// Plans the frame and its blocks, and makes what the plans need. The result begins with the diagnostics
    /// of `asked`. `inputsDiffer`: variables or the size, which steps may read.
    Diagnostics prepare(Result<PlanRequest> asked, bool inputsDiffer = false);
    /// For a new `plan`. Draws whose program cannot be used show their shapes in one colour.
    void makeDrawer();
    /// Runs the Once and Step blocks up to `inputs`.
    Diagnostics simulate();
    /// Draws a part of the frame at inputs.time; adds what it reports.
    void draw(const gpu::Target& target, const Shot& shot, Diagnostics& diagnostics);
    /// Call it after each frame, with what drawing it reported.
    void noteDrawn(int width, int height, const Diagnostics& diagnostics);

    /// True if there are Once or Step blocks, and no errors in them.
    [[nodiscard]] bool runsBlocks() const { return simulation && condition != Condition::withoutSteps; }
    /// True if there is a plan; what is planned later is of another moment.
    [[nodiscard]] bool hasPlan() const { return plan.nodes != nullptr; }
    /// True if these diagnostics, the last ones, leave nothing to draw.
    [[nodiscard]] bool stopsWith(const Diagnostics& diagnostics) const;
    /// applyStrict() as the options say, without what quotes files that are not shown (Scene::hiddenFiles).
    void judge(Diagnostics& diagnostics) const;
    /// Notes what errors cost. `ofBlocks`: they are in Once or Step blocks.
    void note(const Diagnostics& diagnostics, bool ofBlocks = false);

    /// The rounds after which the driver ends a loop, measured once.
    int loopLimit();
    /// Makes what records the loops that the driver ends (Frame::recordsLoops), if it ends any. Call it
    /// before the first frame of a plan.
    void recordLoops(const plan::FramePlan& of);
    /// Begins or ends what Direction::watchesLoops says. What was reported before is reported again.
    void watchLoops(bool on);
    /// True if the next frame records: the first with the values of its uniforms, the second, the fourth and
    /// so on, since buffers and time may lengthen loops.
    [[nodiscard]] bool recordsLoops() const;
    /// The loops that the driver has ended since the last call: draw-W08.
    Diagnostics takeCutLoops();
    /// The plan of that list. Without `outOfSight` all draws may be seen.
    [[nodiscard]] plan::FramePlan planList(const scene::NodeList& nodes, const plan::PlanOptions& planOptions,
                                           const OutOfSight& outOfSight = {});
    /// True if the scene has Once or Step blocks. prepare() then reports what plan::reportNames() finds in
    /// all lists, so the plan of the frame must not (PlanOptions::reportsNames).
    [[nodiscard]] bool hasBlocks() const { return !scene.once.empty() || !scene.steps.empty(); }
    /// Of the frame, then of the Once and Step blocks.
    [[nodiscard]] std::vector<const plan::FramePlan*> plans() const;
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
    /// Plans the Once and Step blocks, if there are any, or checks the frame's plan against them.
    Diagnostics planSimulation(const PlanRequest& asked);

    Direction direction_;
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
