#pragma once
// Which object of the scene is seen at a pixel.

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "gpu/target.h"
#include "view/scene/live_scene.h"

namespace glibra::view {

struct Picked {
    int line = 0;           ///< of the scene, counted from 1
    int ordinal = 0;        ///< which of the scene's draws into the window, counted from 0
    std::string word;       ///< the command
    glm::dvec3 eye{0.0};    ///< the point of the object under the pixel, in eye space with all transforms
    glm::dvec3 point{0.0};  ///< the same in the object's model space
};

/// Draws the one pixel once more, through the scene's own stages, and counts which draw's fragments last pass
/// the depth test there: exact for whatever shaders move or discard. `picture` holds the frame of that time.
/// Nothing where the background is seen.
std::optional<Picked> pick(LiveScene& scene, const gpu::Target& picture, double time, int x, int y);

}  // namespace glibra::view
