#pragma once
// Takes pictures of a scene: what they ask of its conductor, tiles and readback. It draws no small pictures
// first, whatever options.maxError is.

#include <glibra/render.h>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "render/conductor.h"
#include "render/draw/axes.h"
#include "render/draw/view_matrices.h"
#include "render/gpu_times.h"
#include "render/scene_file.h"

namespace glibra::render {

struct SceneState {
    SceneState(gpu::Context& usedContext, const RenderOptions& usedOptions, InterpretedScene interpreted,
               bool isTiled, Stats& stats, SharedParts* shared);
    SceneState(const SceneState&) = delete;
    SceneState& operator=(const SceneState&) = delete;

    /// Needs no GL. Reports glib-E15 for a picture that is too large.
    static Result<std::unique_ptr<SceneState>> of(gpu::Context& context, InterpretedScene interpreted,
                                                  const RenderOptions& options, Stats& stats,
                                                  SharedParts* shared);
    /// A scene that is ready to draw; no value if nothing can be drawn.
    static Result<std::unique_ptr<SceneState>> load(gpu::Context& context, InterpretedScene interpreted,
                                                    const RenderOptions& options, Stats& stats,
                                                    SharedParts* shared);

    Conductor conductor;
    std::vector<Tile> tiles;      ///< with their margins
    std::vector<Tile> tileParts;  ///< the part of each tile that goes into the picture
    std::optional<gpu::Target> window;
    int width = 0, height = 0;
    /// What becomes of the pixels of a frame once they are read, on the CPU. A later frame may be drawn
    /// before.
    struct Finish {
        std::optional<LabelBlock> labels;  ///< the values of uniform variables (options.labels)
        bool isIncomplete = false;

        [[nodiscard]] image::Image finished(image::Image picture) const;
    };
    /// A picture that is drawn, and not yet read.
    struct Ahead {
        Diagnostics diagnostics;
        Finish finish;
        Condition condition = Condition::whole;
        bool isRead = false;  ///< by `stream`
    };
    std::deque<Ahead> ahead;
    std::optional<gpu::PixelStream> stream;
    GpuTimes* gpuTimes = nullptr;  ///< SceneRenderer::measureGpu()
    /// Chooses counts for the scene as it is now, before it is planned with these options. May be empty.
    std::function<Diagnostics(SceneState& state, plan::PlanOptions& planOptions)> choose;
    bool areSamplesChosen = false;  ///< by options.maxError

    /// What is asked of a plan. No value if an option names what the scene does not have.
    [[nodiscard]] Result<PlanRequest> request(bool everything = false);
    /// Makes what draws the pictures of the plan. `diagnostics` are those of the scene so far. False if
    /// nothing can be drawn.
    bool makeReady(Diagnostics& diagnostics);
    /// Interprets and plans the scene for this time, if it is another one.
    Diagnostics moveTo(double time, Stats& stats);
    /// Translates programs, makes meshes and reads textures that the plan will probably need. Needs no GL.
    void makeAhead();

    /// SceneRenderer::draw.
    Result<image::Image> draw(double time, Stats& stats);
    /// Of the frame that was drawn last.
    [[nodiscard]] Finish finish() const;
    /// A picture of the right size and type.
    [[nodiscard]] image::Image emptyPicture() const;
    [[nodiscard]] gpu::PixelLayout pixelLayout() const;
    /// Draws a tile into `window`, and adds what it reports.
    void drawTile(std::size_t index, Diagnostics& diagnostics, Stats& stats);
    /// What is true after a frame, whether it could be drawn or not.
    void endFrame(Diagnostics& diagnostics, Stats& stats);

  private:
    [[nodiscard]] Result<plan::PlanOptions> planOptions(bool everything);
    void listSkipped();
    void explainSimulation();
    void equip(FrameDrawer& drawer);
    [[nodiscard]] Diagnostics checkTiles() const;
    /// Why nothing of the draw can be seen, or an empty text. Without `remarks` the diagnostics of its mesh
    /// are reported later.
    std::string outOfSight(const scene::Draw& draw, const scene::Pass& pass, Diagnostics* remarks);
    /// Reads the tile that was drawn.
    Diagnostics readTile(std::size_t index, image::Image& picture, Stats& stats);

    Diagnostics ofMeshes_;  ///< that outOfSight() has found for the plan that is being made
};

}  // namespace glibra::render
