#pragma once
// The folders of the scenes, shaders, textures and models that ship with glibra.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <vector>

namespace glibra::view {

/// The folder with the examples: the first of `roots` that is a library, or else the nearest library above
/// the program, or else above the scene (base/own_library.h). Empty if there is none.
std::filesystem::path exampleRoot(const std::vector<std::filesystem::path>& roots,
                                  const std::filesystem::path& scene, const std::filesystem::path& program);

/// True for the scenes, shaders, textures and models that ship with the running program, and for any other
/// file in their folders, whether it exists or not. They are not written to.
bool isExample(const std::filesystem::path& file);
/// view-E03 if the file may not be written, because it is in such a folder.
Diagnostics writingProblem(const std::filesystem::path& file);

}  // namespace glibra::view
