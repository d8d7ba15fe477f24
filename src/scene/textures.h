#pragma once
// Finds the dimension of a texture file, and whether it holds noise, without reading its texels (language,
// 8.1, 8.3 and 9.5), and its size. At most 32 bytes and the length of the file are read, of a JPEG picture
// the heads of its segments.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "base/files.h"
#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::scene {

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
