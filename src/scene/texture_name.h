#pragma once
// The name of a texture or a part of it, as a command line gives it.

#include <glibra/result.h>

#include <string_view>

#include "scene/scene.h"

namespace glibra::scene {

/// The texture or part of that name: "shadow", "glow.level(2)", "sky.face(3)", "slices.layer(0)",
/// "lamps.layer(1).face(3)", "life.prev". Errors have no place and say which names the scene has.
Result<TextureView> textureNamed(const Scene& scene, std::string_view text);

}  // namespace glibra::scene
