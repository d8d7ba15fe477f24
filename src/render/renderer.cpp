#include <glibra/render.h>

#include <optional>
#include <utility>

#include "base/device_lost.h"
#include "gpu/context/context.h"
#include "render/probe/nan_search.h"
#include "render/scene_renderer.h"

namespace glibra {

struct Renderer::State {
    State(Driver asked, gpu::Context opened) : driver(asked), context(std::move(opened)) {}
    Result<Picture> render(const std::filesystem::path& scene, const RenderOptions& options);

    Driver driver;
    std::optional<gpu::Context> context;  ///< empty after a reset of the device
};

namespace {

Result<gpu::Context> openFor(Driver driver) {
    gpu::ContextOptions options;
    options.driver = driver;
    return gpu::openContext(options);
}

}  // namespace

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::open(Driver driver) {
    Result<gpu::Context> context = openFor(driver);
    if (!context) return std::move(context.diagnostics);
    return {Renderer(std::make_unique<State>(driver, std::move(*context))), std::move(context.diagnostics)};
}

Result<Picture> Renderer::render(const std::filesystem::path& scene, const RenderOptions& options) {
    if (!state_->context) {
        Result<gpu::Context> context = openFor(state_->driver);
        if (!context) return std::move(context.diagnostics);
        state_->context = std::move(context.value);
    }
    try {
        return state_->render(scene, options);
    } catch (const base::DeviceLost& lost) {
        state_->context.reset();
        return base::diagnosticOf(lost, scene.string());
    }
}

Result<Picture> Renderer::State::render(const std::filesystem::path& scene, const RenderOptions& options) {
    render::Stats stats;
    Result<render::SceneRenderer> loaded = render::SceneRenderer::load(*context, scene, options, stats);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    if (!loaded) return diagnostics;
    Result<image::Image> image = loaded->draw(options.time, stats);
    append(diagnostics, std::move(image.diagnostics));
    if (options.checkNan)
        if (Result<render::NanSearch> search = render::NanSearch::load(*context, scene, options))
            append(diagnostics, search->at(options.time));
    if (!image || (hasError(diagnostics) && !options.incomplete)) return diagnostics;
    Picture picture;
    picture.width = image->width;
    picture.height = image->height;
    picture.components = image->components;
    picture.isFloat = image->type == image::Component::f32;
    picture.data = std::move(image->data);
    return {std::move(picture), std::move(diagnostics)};
}

}  // namespace glibra
