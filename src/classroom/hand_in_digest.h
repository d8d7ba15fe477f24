#pragma once
// Whether a student has handed in something else since points were typed.

#include <glibra/render.h>

#include <filesystem>
#include <span>
#include <string>

namespace glibra::classroom {

/// A digest of what was handed in, by names and contents; of files beyond a limit by their sizes alone. Of a
/// folder these are all its files; of a scene that lies alone among the submissions it is the scene and all
/// that the pictures read of that folder, but not what was given to all (`shaders` and `textures`).
std::string digestOfHandIn(const std::filesystem::path& handedIn, std::span<const RenderOptions> pictures);

}  // namespace glibra::classroom
