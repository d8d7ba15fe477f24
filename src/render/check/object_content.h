#pragma once
// Reads textures and buffers of a scene from the device as numbers.

#include <glibra/result.h>

#include <optional>

#include "render/check/content.h"
#include "render/load/device_scene.h"
#include "scene/scene.h"

namespace glibra::render {

/// The content of a texture, a part of it, or a buffer. Textures of integers give the integers, depth
/// textures one component. Makes the mipmaps if a level above 0 is read. Reports check-E02 with the reason
/// for what cannot be read.
Result<Content> contentOf(const scene::Scene& scene, DeviceScene& device, const scene::ObjectView& object);

/// The content of one level of a texture without samples, in all layers or one; level and layer must exist.
Result<Content> contentOf(const gpu::Texture& texture, int level, std::optional<int> layer);

}  // namespace glibra::render
