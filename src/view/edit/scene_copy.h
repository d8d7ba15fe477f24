#pragma once
// Copies a scene to another place, with the files that it would not find there.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string_view>
#include <vector>

#include "render/live/live_scene.h"

namespace glibra::view {

/// A file of a scene that goes along with a copy of the scene.
struct CopiedFile {
    std::filesystem::path from, to;
};

/// The files that a copy of the scene at `target` needs beside it: those that `live` has read and that the
/// copy would not find, or, with `all`, each of them. Files in or below the folder of the scene keep their
/// relative places, and others go where the scene's names for them lead. The scene itself is not among them.
std::vector<CopiedFile> filesOfCopy(const render::LiveScene& live, const std::filesystem::path& target,
                                    bool all, const std::vector<std::filesystem::path>& libraryRoots);

/// Writes the text as the scene `target`, and copies the files. Folders are made. A file that exists with
/// the same content is kept; one with another content is an error (file-E10), and then nothing is written.
Diagnostics writeCopy(std::string_view text, const std::filesystem::path& target,
                      const std::vector<CopiedFile>& files);

}  // namespace glibra::view
