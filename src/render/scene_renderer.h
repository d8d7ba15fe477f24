#pragma once
// A loaded scene, which draws its picture for any time. Programs, meshes and textures stay on the device
// between frames.

#include <glibra/render.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/pixel_stream.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"
#include "scene/interpret.h"
#include "scene/scene.h"

namespace glibra::render {

class DeviceScene;
class FrameDrawer;
class GpuTimes;
class OpenChecks;
class PreparedScene;
class ViewMatrices;
struct BufferContent;
struct InterpretedScene;

/// What a picture depends on besides its scene: the values of Timer that its programs read, one per period,
/// and the time if the scene changes with it.
using Moment = std::vector<double>;

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
    Result<image::Image> draw(double time, Stats& stats);

    /// True if the driver draws while this process does other work, so that drawAhead() saves time. Pictures
    /// in tiles, and those of a driver that draws on the processor, are read at once.
    [[nodiscard]] bool gainsFromDrawingAhead() const;
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
    Result<image::Image> textureImage(const scene::TextureView& view);

    /// The content of a buffer after the last picture, with the members that the first program which uses it
    /// declares. The buffer must be among options.wantedObjects or seen in the picture. Waits for the device.
    Result<BufferContent> bufferContent(const scene::BufferView& view);
    /// The notes of the Print statements (check-N02) about what the buffers hold now.
    Diagnostics printed();

    /// True if the scene has Expect statements that run, or may do so at a time that they name.
    [[nodiscard]] bool hasChecks() const;
    /// True if it has Expect statements that do not run, which answerChecks() reports.
    [[nodiscard]] bool hasIdleChecks() const;
    /// Answers the checks at their own times, and at `time` those without one: an error for each that does
    /// not hold or cannot be answered. Draws the pictures that it needs, at least that of `time`, and adds
    /// what drawing them reports to `reported`, the scene's own diagnostics. What Expect error asks for is
    /// removed from these.
    Diagnostics answerChecks(double time, Diagnostics& reported, Stats& stats);

    /// Moves the pictures that follow right and up by parts of a pixel; averaging many of them gives a
    /// picture of many samples. Passes into textures move by `textures` texels, in their order; passes
    /// without an entry do not move. Needs options.tileSize > 0, even for one tile.
    void setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures = {});

    /// Replaces the view of the pictures that follow.
    void setView(const ViewMatrices& view);

    /// Measures the GPU time of all that is drawn from now on. `times` must outlive the renderer.
    void measureGpu(GpuTimes& times);

    /// The parts of the renderer, for measurements between two draws.
    FrameDrawer& drawer();
    [[nodiscard]] const DeviceScene& device() const;
    [[nodiscard]] const scene::Scene& scene() const;
    [[nodiscard]] const plan::FramePlan& plan() const;
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// True if a picture may depend on earlier ones, through rendered textures or images that a shader writes
    /// to. Otherwise each picture is the one that a newly loaded scene gives.
    [[nodiscard]] bool remembersFrames() const;
    /// True if the scene has Once or Step blocks. A picture is drawn faster after an earlier one than alone.
    [[nodiscard]] bool runsSteps() const;
    /// Pictures with equal moments are equal. Nothing if remembersFrames().
    [[nodiscard]] std::optional<Moment> momentOf(double time) const;

    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    struct State;  // in the implementation only

  private:
    explicit SceneRenderer(std::unique_ptr<State> state);
    Diagnostics answerAt(double moment, OpenChecks& open, Stats& stats);
    static PreparedScene begin(gpu::Context& context, const std::filesystem::path& scene,
                               const RenderOptions& options, Stats& stats, SharedParts* shared);
    static Result<std::unique_ptr<State>> chooseValues(std::unique_ptr<State> state, Stats& stats);
    static Result<SceneRenderer> finish(Result<std::unique_ptr<State>> prepared, Stats& stats);
    std::unique_ptr<State> state_;
};

/// A scene that is prepared up to the use of GL. The arguments of prepare() must outlive it.
class PreparedScene {
  public:
    PreparedScene(PreparedScene&&) noexcept;
    PreparedScene& operator=(PreparedScene&&) noexcept;
    ~PreparedScene();

  private:
    friend class SceneRenderer;
    PreparedScene();
    Diagnostics diagnostics_;  ///< of its text
    bool isStrict_ = false;
    Result<std::unique_ptr<SceneRenderer::State>> state_;
};

/// A scene as it is at time 0, with what gives it for other inputs.
struct InterpretedScene {
    scene::Scene scene;
    std::shared_ptr<scene::Interpretation> source;  ///< null: the scene is the same for all inputs
    scene::FrameInputs inputs;                      ///< of `scene`

    /// True if the scene changes with time.
    [[nodiscard]] bool changesWithTime() const;
};

/// Reads and interprets a scene file. The result holds the diagnostics of both steps, and no value only if
/// the file cannot be read (glib-E14, glib-E15). Values of variables come from options.set.
Result<InterpretedScene> interpretFile(const std::filesystem::path& path, const RenderOptions& options,
                                       Stats& stats);
/// Parses RenderOptions::set; no value if an entry cannot be parsed.
Result<std::vector<plan::Override>> parseOverrides(const std::vector<std::string>& set);

/// A shader as the driver gets it.
struct TranslatedShader {
    std::string name;  ///< "3-Dots.frag": number of the program in its scene, its name, the stage
    std::string source;
};

/// The result of glibra check.
struct CheckResult {
    Diagnostics diagnostics;
    std::vector<TranslatedShader> shaders;
};

/// Resolves and reads every file, and compiles and links every program. Draws nothing and skips nothing.
CheckResult checkScene(gpu::Context& context, const std::filesystem::path& scene,
                       const RenderOptions& options);

/// What is left of the reports of a scene that cannot be drawn: what Expect error asks for is removed. If no
/// error is left, each other check is check-E02.
Diagnostics answerWithoutPicture(const std::filesystem::path& scene, const RenderOptions& options,
                                 Diagnostics reported);

/// Draws the scene and answers its checks, for `glibra check --run`. The result has what was reported,
/// without what Expect error asks for, and an error for each check that does not hold. `known` is what
/// checkScene() has reported, which the result keeps.
Diagnostics runChecks(gpu::Context& context, const std::filesystem::path& scene, const RenderOptions& options,
                      Diagnostics known = {});

/// Removes repeated diagnostics. With `strict` every warning becomes an error with the same id and text.
void applyStrict(Diagnostics& diagnostics, bool strict);

}  // namespace glibra::render
