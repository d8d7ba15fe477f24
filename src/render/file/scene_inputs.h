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

/// What a picture of a scene reads.
struct ReadByScene {
    /// The scene, scripts that it includes, shaders with what they include, textures and models. They are
    /// sorted, each once. Of a scene with errors those that are known.
    std::vector<std::filesystem::path> files;
    bool changesWithTime = false;  ///< another time may read other files
    /// False if the picture needs so many steps that not all of them were looked at; they may read more
    /// files.
    bool isWhole = true;
};

/// The scene is interpreted with exactly these options: for the picture's time, for the times that its checks
/// ask for and, if a model or an included script may depend on them, for the steps before.
ReadByScene filesReadBy(const std::filesystem::path& scene, const RenderOptions& options);

}  // namespace glibra::render
