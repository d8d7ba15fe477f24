#pragma once
// Anisotropic filters of Mesa's software drivers read every texel that a pixel covers. Where a texture has no
// coarser level left, those are millions: a plane to the horizon takes minutes.

#include "glsl/types/translated_program.h"
#include "scene/scene.h"

namespace glibra::render {

/// True if a texture or sampler of the scene has `aniso`.
bool filtersAnisotropically(const scene::Scene& scene);

/// Rewrites a fragment stage so that texture() of a sampler2D reads at most 16 x 16 texels of the coarsest
/// level for a pixel that covers more than kMostTexels of them. All other pixels keep their bytes. Does
/// nothing for other stages and below GLSL 4.30. Returns whether it has changed the stage.
bool boundFilter(glsl::TranslatedStage& stage);
inline constexpr int kMostTexels = 1024;

}  // namespace glibra::render
