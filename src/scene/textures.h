#pragma once
// What of a texture file is known without reading its texels: the dimension, and whether it is noise
// (language, 8.1, 8.3 and 9.5). At most 32 bytes and the length of a file are looked at.

#include <filesystem>
#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace glibra::scene {

/// The target that `Texture` puts the file into: 2D for pictures; for raw textures the smallest dimension
/// whose header fits the length exactly; 2D for everything else, which the reader refuses.
TextureTarget targetOfFile(const std::filesystem::path& path);

/// A raw byte texture of exactly n x n (x n) texels.
bool holdsNoise(const std::filesystem::path& path, int dimensions, int size);

/// The size in a name such as noise3d.064.tex, folders and case ignored; nothing for other names and for
/// sizes that the built-in noise does not have.
struct NoiseName {
    int dimensions = 3;
    int size = 64;
};
std::optional<NoiseName> noiseNameOf(std::string_view fileName);

/// "noise3d.064.tex"
std::string noiseFileName(int dimensions, int size);

/// The noise file beside the scene: its path and note file-N01 if there is one that holds noise of that size,
/// no path and file-W10 if it holds something else, nothing at all if there is none.
FileReference noiseFileBeside(const std::filesystem::path& sceneFolder, int dimensions, int size,
                              const Place& place);

}  // namespace glibra::scene
