#pragma once
// Targets that stand for the window: one colour, depth and stencil. And what is in them.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gpu/object/framebuffer.h"
#include "gpu/object/readback.h"
#include "image/image.h"
#include "render/live/live_scene.h"
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

// Finds the object of the scene that is visible at a pixel.

struct Picked {
    DrawId draw;
    int ordinal = 0;        ///< index among the scene's draws into the window, counted from 0
    std::string word;       ///< the command
    glm::dvec3 eye{0.0};    ///< the object's point at the pixel, in eye space with all transforms
    glm::dvec3 point{0.0};  ///< the same point in the object's model space
    /// The middle of the object's box in model space, and half its size. `point` and 0 if the box is not
    /// known.
    glm::dvec3 centre{0.0}, half{0.0};
};

/// The draws of the frame's passes into the window, in order; Picked::ordinal is an index into these.
std::vector<const scene::Draw*> windowDraws(const scene::Scene& scene);

/// The last draw into the window whose fragments pass at the pixel; null if there is none. `row` counts from
/// the lower edge. Draws the window's passes again, in that pixel alone.
const plan::PlannedDraw* visibleDraw(render::LiveScene& scene, const gpu::Target& picture, double time, int x,
                                     int row);

/// Draws the one pixel again through the scene's own stages, and finds the draw whose fragments are the last
/// to pass the depth test there. This is exact whatever the shaders discard or move. `picture` holds the
/// frame of that time; x counts to the right and y downwards. Empty where the background is visible.
std::optional<Picked> pick(render::LiveScene& scene, const gpu::Target& picture, double time, int x, int y);

}  // namespace glibra::view
