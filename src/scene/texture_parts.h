#pragma once
// Sizes of textures and of their parts, as far as they are known without reading a file.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace glibra::scene {

/// True for layers of 1D and 2D textures and of cube maps.
bool isArray(TextureTarget target);
/// The dimensions of a texture or of one layer or face: 1, 2 or 3.
std::size_t sideCount(TextureTarget target);

/// The mipmap levels of a texture; nothing if that depends on a file.
std::optional<int> levelsOf(const Texture& texture);
/// Width, height and layers of a level: 6 layers for a cube map, the depth at that level for a 3D texture.
/// Nothing for textures of files.
std::optional<std::array<int, 3>> sizeOfLevel(const Texture& texture, int level);

/// How many layers or faces a level has; nothing if that depends on a file.
std::optional<int> layersOf(const Texture& texture, int level);

/// Width and height of the targets of a pass; nothing for the window and for textures of files.
std::optional<std::array<int, 2>> targetSize(const Scene& scene, const Pass& pass);

/// The number of the face of a cube map: 0 to 5 for "+x", "-x", "+y", "-y", "+z", "-z".
std::optional<int> faceNamed(std::string_view word);

/// "1D", "2D", "3D", "cube", "2DArray", "rectangle".
std::string_view wordOf(TextureTarget target);

}  // namespace glibra::scene
