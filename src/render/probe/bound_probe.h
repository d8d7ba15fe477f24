#pragma once
// Measures on small pictures what the values of a scene's Bound variables do, and chooses them.

#include <glibra/render.h>

#include "budget/choose_bounds.h"
#include "gpu/context/context.h"
#include "render/scene_file.h"

namespace glibra::render {

/// True if the scene declares a variable with Bound.
bool hasBounds(const scene::Scene& scene);

/// Chooses the values for options.maxError, at options.time and up to options.lastTime, and runs the scene
/// with them: `interpreted` then holds that scene, and `options` states the values by `set`. The picture has
/// `width` x `height` pixels; the longer side of the small ones has at most 800. Nothing changes if nothing
/// can be chosen.
budget::ChosenBounds chooseBounds(gpu::Context& context, InterpretedScene& interpreted,
                                  RenderOptions& options, int width, int height);

}  // namespace glibra::render
