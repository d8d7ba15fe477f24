#pragma once
// Targets that stand for the window: one colour, depth and stencil. And what is in them.

#include <optional>

#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "render/load/device_textures.h"

namespace glibra::view {

/// For pictures of that scene.
inline Result<gpu::Target> windowTarget(const gpu::Capabilities& capabilities, const scene::Scene& scene,
                                        int width, int height,
                                        gpu::TexelFormat format = gpu::TexelFormat::rgba8, int samples = 1) {
    return gpu::Target::window(capabilities, width, height, format, samples,
                               render::depthFormat(scene.reversesWindow));
}

/// Makes the target anew if its size or the format of its depth differs, or if only one of both has several
/// samples. Returns why there is none; empty on success.
inline Diagnostics fit(std::optional<gpu::Target>& target, const gpu::Capabilities& capabilities,
                       const scene::Scene& scene, int width, int height,
                       gpu::TexelFormat format = gpu::TexelFormat::rgba8, int samples = 1) {
    if (target && target->width() == width && target->height() == height &&
        (target->samples() > 1) == (samples > 1) &&
        target->depth()->format() == render::depthFormat(scene.reversesWindow))
        return {};
    target.reset();
    Result<gpu::Target> made = windowTarget(capabilities, scene, width, height, format, samples);
    target = std::move(made.value);
    return target ? Diagnostics() : std::move(made.diagnostics);
}

/// The picture in bytes, top row first.
inline Result<image::Image> imageOf(const gpu::Capabilities& capabilities, const gpu::Target& picture,
                                    int components) {
    const int width = picture.width(), height = picture.height();
    auto pixels = gpu::readPixels(capabilities, picture.readable(), 0, {0, 0, width, height},
                                  {components, gpu::TexelType::u8});
    if (!pixels) return std::move(pixels.diagnostics);
    return image::Image{width, height, components, image::Component::u8, std::move(*pixels)};
}

}  // namespace glibra::view
