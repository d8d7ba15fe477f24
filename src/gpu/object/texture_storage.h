#pragma once
// Private to this folder: the memory of a texture's texels.

#include <glad/gl.h>

#include <cstddef>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/texture_shape.h"

namespace glibra::gpu {

// Uploads and queries use this unit and replace its binding; every draw binds its own textures.
inline constexpr int kWorkUnit = 0;

/// The driver's limit of width, height and, except for arrays, depth.
int largestSide(const Capabilities& capabilities, TextureShape shape);
/// Allocates the texels of the bound texture; from GL 4.2 on as immutable storage.
void allocate(const Capabilities& capabilities, const TextureLayout& layout);
/// Fills a level of the bound texture, which has one sample. `faceBytes`: bytes of one face of a cube map.
void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes);

}  // namespace glibra::gpu
