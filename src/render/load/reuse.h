#pragma once
// Keys that say what a shape or a texture is made from, so that a scene that is read again keeps what has not
// changed.

#include <string>

#include "scene/scene.h"

namespace glibra::render {

/// Shapes with equal keys give the same mesh. A key holds the command and its numbers, and a file's path,
/// length and modification time. It is empty for shapes whose vertices are in the scene's text; they are
/// never reused.
std::string reuseKey(const scene::Scene& scene, const scene::Shape& shape);

/// The same for textures. It is empty for render targets, whose content belongs to the drawn frames.
std::string reuseKey(const scene::Scene& scene, const scene::Texture& texture);

}  // namespace glibra::render
