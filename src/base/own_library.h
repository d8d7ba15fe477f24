#pragma once
// The scenes, shaders, textures and models that ship with this program.

#include <filesystem>

namespace glibra::base {

/// True if the folder has `glib` and `shaders`, as the library that ships with glibra has.
bool isLibrary(const std::filesystem::path& folder);

/// The nearest library: the folder (empty: the current one), its `share/glibra` (an installation, which may
/// be moved), or the same of a folder above it. Empty if there is none.
std::filesystem::path libraryAbove(std::filesystem::path folder);

/// The library of the running program. Empty if there is none.
std::filesystem::path ownLibrary();

}  // namespace glibra::base
