#pragma once
// What is known of textures without their texels: sizes, parts, names, and the dimensions of files.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/files.h"
#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::scene {

// ---- Parts and sizes
// As far as they are known without reading a file.

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

// ---- Names
// The name of a texture, a part of it, or a buffer, as a command line gives it.

/// The texture or part of that name: "shadow", "glow.level(2)", "sky.face(3)", "slices.layer(0)",
/// "lamps.layer(1).face(3)", "life.prev". Errors have no place and say which names the scene has.
Result<TextureView> textureNamed(const Scene& scene, std::string_view text);

/// The same, or the buffer of that name: "Particles", "Particles.prev".
Result<ObjectView> objectNamed(const Scene& scene, std::string_view text);

// ---- Files
// Finds the dimension of a texture file, and whether it holds noise, without reading its texels (language,
// 8.1, 8.3 and 9.5), and its size. At most 32 bytes and the length of the file are read, of a JPEG picture
// the heads of its segments.

/// The target of a file that `Texture` names: 2D for pictures; for raw textures the smallest dimension whose
/// header fits the length exactly; 2D for everything else, which is rejected when it is read.
TextureTarget targetOfFile(const base::FileSource& source);

/// Width, height and depth of the texels that a texture of that many dimensions (1 to 3) has from the file.
/// Nothing for files that are no BMP, JPEG, PNG or raw texture.
std::optional<std::array<double, 3>> sizeOfFile(const base::FileSource& source, std::size_t dimensions);

/// True if the file is a raw byte texture of exactly size x size (x size) texels.
bool holdsNoise(const base::FileSource& source, int dimensions, int size);

/// Dimensions and size from a name such as noise3d.064.tex. Folders and case are ignored. Returns nothing for
/// other names and for sizes that the built-in noise does not have.
struct NoiseName {
    int dimensions = 3;
    int size = 64;
};
std::optional<NoiseName> noiseNameOf(std::string_view fileName);

/// "noise3d.064.tex"
std::string noiseFileName(int dimensions, int size);

/// The noise file beside the scene. If it holds noise of that size, the result has its path and the note
/// file-N01; if it holds something else, the warning file-W10 and no path; if it is missing or must not be
/// read, neither.
FileReference noiseFileBeside(const SearchFolders& folders, int dimensions, int size, const Place& place);

}  // namespace glibra::scene
