#pragma once
// The state of a SceneRenderer, for the files that implement it.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/axes.h"
#include "render/draw/frame.h"
#include "render/draw/simulation.h"
#include "render/draw/tile.h"
#include "render/draw/view_matrices.h"
#include "render/file/labels.h"
#include "render/load/device_scene.h"
#include "render/load/programs.h"
#include "render/load/shared_parts.h"
#include "render/scene_renderer.h"

namespace glibra::render {

class GpuTimes;

/// Members refer to members above them, so the whole state lives on the heap and never moves.
struct SceneRenderer::State {
    State(gpu::Context& usedContext, RenderOptions usedOptions, InterpretedScene interpreted, bool tiled,
          Stats& stats, SharedParts* shared)
        : context(usedContext),
          loadStats(stats),
          options(std::move(usedOptions)),
          changesWithTime(interpreted.changesWithTime()),
          source(std::move(interpreted.source)),
          inputs(std::move(interpreted.inputs)),
          scene(std::move(interpreted.scene)),
          ownParts(options.maxError > 0 && options.skip && !shared ? std::make_unique<SharedParts>()
                                                                   : nullptr),
          parts(ownParts ? ownParts.get() : shared),
          programs(context, scene, options, tiled, stats, parts),
          device(context, scene, stats, parts, options.skip) {}

    /// Needs no GL. Reports glib-E15 for a picture that is too large.
    static Result<std::unique_ptr<State>> of(gpu::Context& context, InterpretedScene interpreted,
                                             const RenderOptions& options, Stats& stats, SharedParts* shared);

    gpu::Context& context;
    Stats& loadStats;  ///< of loading the scene; it lives as long as this
    RenderOptions options;
    bool changesWithTime;
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene never changes
    scene::FrameInputs inputs;                      ///< of `scene`
    scene::Scene scene;
    std::unique_ptr<SharedParts> ownParts;  ///< shared by the picture and the probes of the error bound
    SharedParts* parts;                     ///< `ownParts`, or what other scenes share, or null
    ProgramLibrary programs;
    DeviceScene device;
    plan::FramePlan plan;
    /// The last moment that was drawn, if it was another one than that of `scene` and `plan`.
    struct Drawn {
        scene::Scene scene;
        plan::FramePlan plan;
    };
    std::unique_ptr<Drawn> drawnBefore;
    bool isDrawn = false;                  ///< `scene` and `plan`, completely, and nothing was drawn since
    std::int64_t drawnChanges = 0;         ///< Simulation::changes() of what was drawn
    std::optional<Simulation> simulation;  ///< of a scene with Once or Step
    std::optional<FrameDrawer> drawer;
    std::optional<Axes> axes;
    std::vector<Tile> tiles;      ///< with their margins
    std::vector<Tile> tileParts;  ///< the part of each tile that goes into the picture
    std::optional<gpu::Target> window;
    int width = 0, height = 0;
    /// A picture that is drawn, and not yet read.
    struct Ahead {
        Diagnostics diagnostics;
        std::optional<LabelBlock> labels;
        bool isIncomplete = false;
        bool isRead = false;     ///< by `stream`
        bool isStopped = false;  ///< there is no picture
    };
    std::deque<Ahead> ahead;
    std::optional<gpu::PixelStream> stream;
    ViewMatrices view;
    double eyeDistance = 0;        ///< by which the view policy moved the eye back, at time 0
    bool isIncomplete = false;     ///< an error has cost a part of the picture (options.incomplete)
    bool isBroken = false;         ///< nothing can be drawn, in spite of options.incomplete
    bool isMoving = false;         ///< the plan is made for another moment than the first
    bool isStateful = false;       ///< remembersFrames()
    GpuTimes* gpuTimes = nullptr;  ///< measureGpu()

    /// True if nothing can be drawn because of an error. With options.incomplete errors of single things are
    /// noted in isIncomplete instead.
    [[nodiscard]] bool isStopped(const Diagnostics& diagnostics);
    [[nodiscard]] plan::FramePlan planScene(const plan::PlanOptions& planOptions);
    [[nodiscard]] plan::FramePlan planList(const scene::NodeList& nodes,
                                           const plan::PlanOptions& planOptions);
    /// Plans the Once and Step blocks, if there are any, or checks the frame's plan against them.
    void explainSimulation(Stats& stats) const;
    Diagnostics planSimulation(const plan::PlanOptions& planOptions, Stats& stats);
    Diagnostics preparePlan(Stats& stats, bool everything);
    /// Interprets and plans the scene for this time, if it is another one.
    Diagnostics moveTo(double time, Stats& stats);
    void makeDrawer(Stats& stats);
    /// What of the frame is the same as in the frame that was drawn last.
    [[nodiscard]] plan::StillNodes stillNodes() const;
    /// Every node of the next frame is drawn.
    void forgetDrawn();
    [[nodiscard]] Diagnostics checkTiles() const;
    void listFoundByName(Stats& stats) const;
    Diagnostics keepBudget(plan::PlanOptions& planOptions, Stats& stats);
    Diagnostics placeEye(Stats& stats);
    /// Translates programs, makes meshes and reads textures that the plan will probably need. Needs no GL.
    void makeAhead();
    /// Why nothing of the draw can be seen, or an empty text. Without `remarks` the diagnostics of its mesh
    /// are reported later.
    std::string outOfSight(const scene::Draw& draw, const scene::Pass& pass, Diagnostics* remarks);
    [[nodiscard]] bool mayShowEarlierFrames();
    /// The values of uniform variables, which are written over the picture (options.labels).
    [[nodiscard]] std::optional<LabelBlock> labels() const;
    /// A picture of the right size and type.
    [[nodiscard]] image::Image emptyPicture() const;
    /// The means of the window's samples.
    void resolve();
    /// Draws a tile into `window`.
    Diagnostics drawTile(std::size_t index, double time, const plan::StillNodes& still, Stats& stats);
    /// Reads the tile that was drawn.
    Diagnostics readTile(std::size_t index, image::Image& picture, Stats& stats);
    /// What is true after a frame, whether it could be drawn or not.
    void endFrame(Diagnostics& diagnostics, Stats& stats);
};

}  // namespace glibra::render
