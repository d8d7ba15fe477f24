#include <glibra/render.h>

#include <optional>

#include "gpu/context/context.h"
#include "render/probe/nan_search.h"
#include "render/scene_renderer.h"

namespace glibra {

struct Renderer::State {
    explicit State(gpu::Context opened) : context(std::move(opened)) {}
    gpu::Context context;
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::open(Driver driver) {
    gpu::ContextOptions options;
    options.driver = driver;
    Result<gpu::Context> context = gpu::openContext(options);
    if (!context) return std::move(context.diagnostics);
    return {Renderer(std::make_unique<State>(std::move(*context))), std::move(context.diagnostics)};
}

Result<Picture> Renderer::render(const std::filesystem::path& scene, const RenderOptions& options) {
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(state_->context, scene, options, stats);
    Diagnostics diagnostics = std::move(loaded.diagnostics);
    if (!loaded) return diagnostics;
    Result<image::Image> image = loaded->draw(options.time, stats);
    append(diagnostics, std::move(image.diagnostics));
    if (options.checkNan)
        if (Result<render::NanSearch> search = render::NanSearch::load(state_->context, scene, options))
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
