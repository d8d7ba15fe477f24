#pragma once
// One scene, loaded: draws its picture for any time. Programs, meshes and textures stay on the device between
// frames.

#include <glibra/render.h>

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "image/image.h"
#include "plan/frame_plan.h"
#include "render/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

class DeviceScene;
class FrameDrawer;
class PreparedScene;

/// What a picture depends on besides its scene: the values of Timer that its programs read, one a period.
using Moment = std::vector<double>;

class SceneRenderer {
  public:
    /// Parses, interprets, plans, compiles and uploads what a picture needs. Diagnostics of all that are in
    /// the result; with an error among them (or a warning, if strict) there is no value. What `shared` (or
    /// null) has from earlier scenes is used, unless the options say to skip nothing; it must outlive the
    /// renderer.
    static Result<SceneRenderer> load(gpu::Context& context, const std::filesystem::path& scene,
                                      const RenderOptions& options, Stats& stats,
                                      SharedParts* shared = nullptr);

    /// The same from a scene that is interpreted already; its own diagnostics are not repeated.
    static Result<SceneRenderer> of(gpu::Context& context, scene::Scene scene, const RenderOptions& options,
                                    Stats& stats, SharedParts* shared = nullptr);

    /// The part of load() that needs no GL: reads, translates and computes what the plan will probably want.
    /// It may run on another thread while this context draws; `shared` may be in use meanwhile.
    static PreparedScene prepare(gpu::Context& context, const std::filesystem::path& scene,
                                 const RenderOptions& options, Stats& stats, SharedParts* shared = nullptr);
    /// The rest of load(), on the context's thread, with the same `stats`: value and diagnostics are those of
    /// load() by itself.
    static Result<SceneRenderer> load(PreparedScene prepared, Stats& stats);

    /// Draws the picture at that time (seconds): RGB or RGBA (options.alpha), bytes or floats.
    Result<image::Image> draw(double time, Stats& stats);

    /// What colour output `color` of the target of plan().passes[pass] holds after the first `draws` draws of
    /// the plan, counted over all passes: of the window the picture as draw() gives it, of a texture RGBA as
    /// floats. For searches.
    Result<image::Image> drawFirst(std::size_t draws, std::size_t pass, int color, double time, Stats& stats);

    /// Moves the pictures that follow right and up by parts of a pixel: many of them average to one of many
    /// samples. Passes into textures move by `textures`, in texels, in their order; those that it has no
    /// place for stay. Needs options.tileSize > 0, even of one tile.
    void setShift(const glm::dvec2& window, std::vector<glm::dvec2> textures = {});

    /// What draws it, and what is on the device: for measurements between two draws.
    FrameDrawer& drawer();
    [[nodiscard]] const DeviceScene& device() const;
    [[nodiscard]] const scene::Scene& scene() const;
    [[nodiscard]] const plan::FramePlan& plan() const;
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;
    /// True if a picture may show what an earlier one left behind: rendered textures, or images that a shader
    /// writes to. Otherwise the pictures of one load are those of a load each.
    [[nodiscard]] bool remembersFrames() const;
    /// Pictures of equal moments are equal. Nothing if it remembers frames.
    [[nodiscard]] std::optional<Moment> momentOf(double time) const;

    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    struct State;  // in the implementation only

  private:
    explicit SceneRenderer(std::unique_ptr<State> state);
    static PreparedScene begin(gpu::Context& context, const std::filesystem::path& scene,
                               const RenderOptions& options, Stats& stats, SharedParts* shared);
    static Result<SceneRenderer> finish(Result<std::unique_ptr<State>> prepared, Stats& stats);
    std::unique_ptr<State> state_;
};

/// A scene on its way to the device. What it was prepared with must outlive it.
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

/// A scene file's text to a Scene. The diagnostics of both steps are in the result; there is no value only if
/// the file cannot be read (glib-E14, glib-E15).
Result<scene::Scene> interpretFile(const std::filesystem::path& path, const RenderOptions& options,
                                   Stats& stats);
/// RenderOptions::set as overrides; no value if one of them cannot be read.
Result<std::vector<plan::Override>> parseOverrides(const std::vector<std::string>& set);

/// A shader as the driver got it.
struct TranslatedShader {
    std::string name;  ///< "3-Dots.frag": number of the program in its scene, its name, the stage
    std::string source;
};

/// What glibra check found out.
struct CheckResult {
    Diagnostics diagnostics;
    std::vector<TranslatedShader> shaders;
};

/// Parses, resolves and reads every file, compiles and links every program; draws nothing, skips nothing.
CheckResult checkScene(gpu::Context& context, const std::filesystem::path& scene,
                       const RenderOptions& options);

/// Removes repeated messages; with `strict` every warning becomes an error with the same id and text.
void applyStrict(Diagnostics& diagnostics, bool strict);

}  // namespace glibra::render
