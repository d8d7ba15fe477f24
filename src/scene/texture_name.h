#pragma once
// The name of a texture, a part of it, or a buffer, as a command line gives it.

#include <glibra/result.h>

#include <string_view>

#include "scene/scene.h"

namespace glibra::scene {

/// The texture or part of that name: "shadow", "glow.level(2)", "sky.face(3)", "slices.layer(0)",
/// "lamps.layer(1).face(3)", "life.prev". Errors have no place and say which names the scene has.
Result<TextureView> textureNamed(const Scene& scene, std::string_view text);

/// The same, or the buffer of that name: "Particles", "Particles.prev".
Result<ObjectView> objectNamed(const Scene& scene, std::string_view text);

}  // namespace glibra::scene
