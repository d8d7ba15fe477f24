#pragma once
// What a scene names and does not have may be in the library that glibra is installed with.

#include <glibra/diagnostic.h>

#include <filesystem>

#include "base/own_library.h"

namespace glibra::cli {

/// A note for the first of the missing files (file-E01) of a scene that the library has, with the --library
/// that finds it. Nothing if the library has none of them, or is searched already.
Diagnostics libraryHint(const std::filesystem::path& scene, const Diagnostics& diagnostics,
                        const std::filesystem::path& library = base::ownLibrary());

}  // namespace glibra::cli
