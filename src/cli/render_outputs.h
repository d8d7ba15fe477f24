#pragma once
// The files of `glibra render`.

#include <filesystem>
#include <vector>

#include "cli/render_arguments.h"
#include "image/file.h"

namespace glibra::cli {

/// Who chose the names of the pictures: the user with -o FILE, and this command otherwise, also for frames.
image::NamedBy namedBy(const RenderArguments& arguments);
/// The file that each scene is written to. Without -o it is the scene's name in the current folder. Where two
/// scenes have the same name, they keep the folders in which they differ.
std::vector<std::filesystem::path> outputFiles(const RenderArguments& arguments);
/// True if all frames go into one file.
bool isFilm(const RenderArguments& arguments);
/// The file, or the first of the files, that a worker writes for a film.
std::filesystem::path framesOf(std::filesystem::path film);

}  // namespace glibra::cli
