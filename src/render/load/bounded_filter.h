#pragma once
// Anisotropic filters of Mesa's software drivers read every texel that a pixel covers. Where a texture has no
// coarser level left, those are millions: a plane to the horizon takes minutes.

#include <optional>

#include "glsl/types/translated_program.h"
#include "scene/scene.h"

namespace glibra::render {

/// How texture() is bounded in the shaders of a scene.
struct FilterBound {
    bool repeats = false;  ///< one of the textures with `aniso` repeats; otherwise coordinates are clamped
};

/// The bound of a scene with `aniso` at a texture or sampler; nothing for other scenes.
std::optional<FilterBound> filterBoundOf(const scene::Scene& scene);

/// Rewrites a fragment stage so that texture() of a sampler2D reads 16 texels of the coarsest level, evenly
/// over the pixel, where that covers more than kMostTexels of them. All other pixels keep their bytes. Does
/// nothing for other stages and below GLSL 4.30. Returns whether it has changed the stage.
bool boundFilter(glsl::TranslatedStage& stage, const FilterBound& bound);
inline constexpr int kMostTexels = 1024;

}  // namespace glibra::render
