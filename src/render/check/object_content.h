#pragma once
// Reads textures and buffers of a scene from the device as numbers.

#include <glibra/result.h>

#include "render/check/content.h"
#include "render/load/device_scene.h"
#include "scene/scene.h"

namespace glibra::render {

/// The content of a texture, a part of it, or a buffer. Textures of integers give the integers, depth
/// textures one component. Reports check-E02 with the reason for what cannot be read.
Result<Content> contentOf(const scene::Scene& scene, const DeviceScene& device,
                          const scene::ObjectView& object);

}  // namespace glibra::render
