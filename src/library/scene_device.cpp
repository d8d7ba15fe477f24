// Pictures and textures of a loaded scene that stay on the device, for a program that draws there itself.

#include <fmt/format.h>
#include <glibra/scene.h>

#include "gpu/format/pixel_format.h"
#include "gpu/object/foreign_target.h"
#include "library/renderer_state.h"
#include "scene/texture_name.h"

namespace glibra {
namespace {

/// library-E08 in a context of the renderer's own, which the caller cannot draw in.
Diagnostics problemsOf(bool isAdopted) {
    if (isAdopted) return {};
    return {diagnose("library-E08",
                     "the renderer draws in a context of its own; open(Renderer::current()) adopts the "
                     "program's")};
}

/// A size of the surface and the one that an option asks for, 0 where nothing is said. False if they differ.
bool agree(int& surface, int option) {
    if (surface == 0) surface = option;
    return option == 0 || option == surface;
}

}  // namespace

Result<void> Scene::State::drawInto(const Surface& surface, DrawOptions wanted) {
    if (Diagnostics problems = problemsOf(renderer->isAdopted); !problems.empty()) return problems;
    int width = surface.width, height = surface.height;
    if (surface.texture != 0) {
        const Result<gpu::TextureSize> size = gpu::sizeOfForeign(surface.texture);
        if (!size) return size.diagnostics;
        if (width == 0) width = size->width;
        if (height == 0) height = size->height;
    }
    if (!agree(width, wanted.width) || !agree(height, wanted.height))
        return wrongOption(fmt::format("the options ask for {} x {} pixels, the surface for {} x {}",
                                       wanted.width, wanted.height, width, height));
    wanted.width = width;
    wanted.height = height;
    return drawn<void>(wanted, [&](const gpu::Target& target) -> Result<void> {
        const gpu::PixelRectangle part{surface.x, surface.y, target.width(), target.height()};
        return gpu::copyInto({surface.framebuffer, surface.texture, part}, target, !wanted.alpha);
    });
}

Result<void> Scene::drawInto(const Surface& surface, const DrawOptions& options) {
    Diagnostics problems = problemsOf(options);
    append(problems, outOfRange({{"surface.width", surface.width, kLargestPictureSide},
                                 {"surface.height", surface.height, kLargestPictureSide}}));
    if (!problems.empty()) return problems;
    return State::guarded<void>(state_.get(), [&] { return state_->drawInto(surface, options); });
}

Result<DeviceTexture> Scene::State::deviceTexture(std::string_view name) {
    if (Diagnostics problems = problemsOf(renderer->isAdopted); !problems.empty()) return problems;
    const Result<scene::TextureView> view = scene::textureNamed(device.live->scene(), name);
    if (!view) return identified(view.diagnostics, "library-E02", path);
    if (view->level || view->layer)
        return diagnose("library-E02", fmt::format("'{}' is a part of a texture, not one", name),
                        {path.generic_string(), 1, 1});
    const gpu::Texture* texture = device.live->completed(view->texture, view->isPrevious);
    if (texture == nullptr)
        return diagnose(
            "library-E07",
            fmt::format("texture '{}' is not on the device: nothing that the picture needs uses it", name),
            {path.generic_string(), 1, 1});
    const gpu::TextureSize& size = texture->size();
    return DeviceTexture{texture->id(),
                         gpu::glTarget(texture->shape()),
                         gpu::internalFormat(texture->format()),
                         size.width,
                         size.height,
                         size.depth,
                         texture->levels()};
}

Result<DeviceTexture> Scene::deviceTexture(std::string_view name) {
    return State::guarded<DeviceTexture>(state_.get(), [&]() -> Result<DeviceTexture> {
        if (!state_->isDrawn) return nothingDrawn();
        return state_->deviceTexture(name);
    });
}

}  // namespace glibra
