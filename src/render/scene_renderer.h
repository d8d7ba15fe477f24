#pragma once
// A loaded scene, which draws its picture for any time. Programs, meshes and textures stay on the device
// between frames.

#include <glibra/render.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/load/shared_parts.h"
#include "render/scene_file.h"
#include "render/scene_state.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

struct BufferContent;

/// What a picture depends on besides its scene: the values of Timer that its programs read, one per period,
/// and the time if the scene changes with it.
using Moment = std::vector<double>;

/// A scene that is prepared up to the use of GL. The arguments of SceneRenderer::prepare() must outlive it.
class PreparedScene {
    friend class SceneRenderer;
    Diagnostics diagnostics_;  ///< of its text
    bool isStrict_ = false;
    Result<std::unique_ptr<SceneState>> state_;
};

class SceneRenderer {
  public:
    /// Parses, interprets, plans, compiles and uploads what a picture needs. The result holds the diagnostics
    /// of all these steps, and no value if there is an error (or, if strict, a warning). Parts of earlier
    /// scenes are taken from `shared` (may be null), unless options.skip is false; it must outlive the
    /// renderer.
    static Result<SceneRenderer> load(gpu::Context& context, const std::filesystem::path& scene,
                                      const RenderOptions& options, Stats& stats,
                                      SharedParts* shared = nullptr);

    /// The same for a scene that is already interpreted; its own diagnostics are not repeated.
    static Result<SceneRenderer> of(gpu::Context& context, InterpretedScene scene,
                                    const RenderOptions& options, Stats& stats,
                                    SharedParts* shared = nullptr);

    /// The part of load() that needs no GL: reads, translates and computes what the plan will probably need.
    /// It may run on another thread while this context draws and uses `shared`.
    static PreparedScene prepare(gpu::Context& context, const std::filesystem::path& scene,
                                 const RenderOptions& options, Stats& stats, SharedParts* shared = nullptr);
    /// The rest of load(), on the context's thread, with the same `stats`. Value and diagnostics are those
    /// that load() would return.
    static Result<SceneRenderer> load(PreparedScene prepared, Stats& stats);

    /// Draws the picture at `time` (seconds) as RGB, or RGBA with options.alpha, in bytes or floats.
    Result<image::Image> draw(double time, Stats& stats) { return state_->draw(time, stats); }

    /// True if the driver draws while this process does other work, so that drawAhead() saves time. Pictures
    /// in tiles, and those of a driver that draws on the processor, are read at once.
    [[nodiscard]] bool gainsFromDrawingAhead() const {
        return state_->tiles.size() == 1 && !state_->conductor.context.capabilities().isSoftware;
    }
    /// Begins to draw the picture at `time`, which takeDrawn() gives. At most kMostAhead pictures may be
    /// begun and not taken. Only for pictures of one tile.
    void drawAhead(double time, Stats& stats);
    /// The picture that was begun first, with its diagnostics, as draw() gives it. Plan, textures and what
    /// else is seen of the renderer may already be those of a later one.
    Result<image::Image> takeDrawn(Stats& stats);
    static constexpr std::size_t kMostAhead = gpu::PixelStream::kMost;

    /// Draws only the first `draws` draws of the plan, counted over all passes, and returns colour output
    /// `color` of the target of plan().passes[pass]: for the window the picture as draw() returns it, for a
    /// texture RGBA floats. NanSearch uses it.
    Result<image::Image> drawFirst(std::size_t draws, std::size_t pass, int color, double time, Stats& stats);

    /// The content of a texture with a name after the last picture, top row first, in the components and the
    /// type that lose the least: bytes, 16 bits, or floats, also for integers and depth. A texture with
    /// layers needs one (`view.layer`); the rows of a face of a cube map are those of its files. The texture
    /// must be among options.wantedObjects or seen in the picture.
    Result<image::Image> textureImage(const scene::TextureView& view) {
        return state_->conductor.device.textures().imageOf(view);
    }
    /// The same as DeviceTextures::numbersOf gives it.
    Result<TexelNumbers> textureNumbers(const scene::TextureView& view) {
        return state_->conductor.device.textures().numbersOf(view);
    }

    /// The content of a buffer after the last picture, with the members that the first program which uses it
    /// declares. The buffer must be among options.wantedObjects or seen in the picture. Waits for the device.
    Result<BufferContent> bufferContent(const scene::BufferView& view);

    /// Moves the pictures that follow right and up by parts of a pixel; averaging many of them gives a
    /// picture of many samples. Passes into textures move by `textures` texels, in their order; passes
    /// without an entry do not move. Needs options.tileSize > 0, even for one tile.
    void setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures = {});

    /// Measures the GPU time of all that is drawn from now on. `times` must outlive the renderer.
    void measureGpu(GpuTimes& times);

    /// The parts of the renderer, for measurements between two draws.
    FrameDrawer& drawer();
    [[nodiscard]] const DeviceScene& device() const { return state_->conductor.device; }
    [[nodiscard]] const scene::Scene& scene() const { return state_->conductor.scene; }
    [[nodiscard]] const plan::FramePlan& plan() const { return state_->conductor.plan; }
    [[nodiscard]] int width() const { return state_->width; }
    [[nodiscard]] int height() const { return state_->height; }
    /// True if a picture may depend on earlier ones, through rendered textures or images that a shader writes
    /// to. Otherwise each picture is the one that a newly loaded scene gives.
    [[nodiscard]] bool remembersFrames() const { return state_->conductor.plan.showsEarlierFrames; }
    /// True if the scene has Once or Step blocks. A picture is drawn faster after an earlier one than alone.
    [[nodiscard]] bool runsSteps() const { return state_->conductor.simulation.has_value(); }
    /// Pictures with equal moments are equal. Nothing if remembersFrames().
    [[nodiscard]] std::optional<Moment> momentOf(double time) const;

    /// What draws the pictures.
    SceneState& state() { return *state_; }

  private:
    explicit SceneRenderer(std::unique_ptr<SceneState> state) : state_(std::move(state)) {}
    static PreparedScene begin(gpu::Context& context, const std::filesystem::path& scene,
                               const RenderOptions& options, Stats& stats, SharedParts* shared);
    static Result<SceneRenderer> finish(Result<std::unique_ptr<SceneState>> prepared, Stats& stats);
    std::unique_ptr<SceneState> state_;
};

}  // namespace glibra::render
