#pragma once
// The files that a scene reads, without a context.

#include <glibra/render.h>

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/file_lookup.h"
#include "scene/scene.h"

namespace glibra::render {

/// The files that the text of a shader includes, as far as they are found. Conditions are not evaluated, so
/// they may be more than a picture needs.
std::vector<std::filesystem::path> includedFiles(std::string_view text, const std::filesystem::path& file,
                                                 const scene::Scene& scene, const RenderOptions& options,
                                                 scene::FolderListings& listings);

/// All files that the scene reads: its own, scripts that it includes, shaders with what they include,
/// textures and models. They are sorted, each once. Of a scene with errors those that are known.
std::vector<std::filesystem::path> filesReadBy(const std::filesystem::path& scene,
                                               const RenderOptions& options);

}  // namespace glibra::render
