#pragma once
// Names for what a shape or a texture is made of, so that a scene read again keeps what has not changed.

#include <string>

#include "scene/scene.h"

namespace glibra::render {

/// Equal for shapes that give the same mesh: command, numbers, and of a file its path, length and time of its
/// last change. Empty for shapes whose vertices stand in the scene's text: they are made anew.
std::string reuseKey(const scene::Scene& scene, const scene::Shape& shape);

/// The same for textures. Empty for empty ones (targets): their content belongs to the frames drawn.
std::string reuseKey(const scene::Scene& scene, const scene::Texture& texture);

}  // namespace glibra::render
