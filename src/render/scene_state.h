#pragma once
// The state of a SceneRenderer, for the files that implement it.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/draw/tile.h"
#include "render/file/labels.h"
#include "render/pipeline.h"

namespace glibra::render {

class GpuTimes;

struct SceneRenderer::State : Pipeline {
    State(gpu::Context& usedContext, const RenderOptions& usedOptions, InterpretedScene interpreted,
          bool isTiled, Stats& stats, SharedParts* shared)
        : Pipeline(usedContext, usedOptions, std::move(interpreted), stats,
                   {isTiled, usedOptions.maxError > 0 && usedOptions.skip, shared}) {}

    /// Needs no GL. Reports glib-E15 for a picture that is too large.
    static Result<std::unique_ptr<State>> of(gpu::Context& context, InterpretedScene interpreted,
                                             const RenderOptions& options, Stats& stats, SharedParts* shared);

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
    bool isIncomplete = false;     ///< an error has cost a part of the picture (options.incomplete)
    bool isBroken = false;         ///< nothing can be drawn, in spite of options.incomplete
    bool isMoving = false;         ///< the plan is made for another moment than the first
    bool isStateful = false;       ///< remembersFrames()
    GpuTimes* gpuTimes = nullptr;  ///< measureGpu()

    /// True if nothing can be drawn because of an error. With options.incomplete errors of single things are
    /// noted in isIncomplete instead.
    [[nodiscard]] bool isStopped(const Diagnostics& diagnostics);
    void explainSimulation(Stats& stats) const;
    /// Pipeline::planSimulation, with the names that only all plans together know.
    Diagnostics planBlocks(const plan::PlanOptions& planOptions, Stats& stats);
    Diagnostics preparePlan(Stats& stats, bool everything);
    /// Interprets and plans the scene for this time, if it is another one.
    Diagnostics moveTo(double time, Stats& stats);
    /// Pipeline::makeDrawer, for pictures and tiles.
    void makePictureDrawer(Stats& stats);
    [[nodiscard]] Diagnostics checkTiles() const;
    void listFoundByName(Stats& stats) const;
    Diagnostics keepBudget(plan::PlanOptions& planOptions, Stats& stats);
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
