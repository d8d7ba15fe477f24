#pragma once
// What another noise texture does to a picture, measured on small pictures of the scene.

#include <glibra/render.h>

#include <optional>
#include <span>

#include "budget/budget.h"
#include "gpu/context.h"
#include "scene/scene.h"

namespace glibra::render {

/// How far contours move from the scene's picture with the noise `from` to that with the noise `to`, in
/// pixels of a picture of `width` x `height`. It is measured on pictures of at most 200 pixels a side.
/// Nothing if they cannot be drawn: whoever draws the scene itself is told why.
std::optional<budget::ContourShifts> noiseShift(gpu::Context& context, const scene::Scene& scene,
                                                const RenderOptions& options, int width, int height,
                                                std::span<const budget::NoiseChoice> from,
                                                std::span<const budget::NoiseChoice> to);

}  // namespace glibra::render
