#pragma once
// Small pictures of scenes, cached between runs. A picture is valid as long as the scene and all files that
// it was made from have the same content.

#include <filesystem>
#include <string>
#include <vector>

#include "gpu/context/context.h"

namespace glibra::view {

inline constexpr int kThumbnailWidth = 320;
inline constexpr int kThumbnailHeight = 240;

/// The cache folder: $XDG_CACHE_HOME/glibra/thumbnails, by default ~/.cache/glibra/thumbnails. Empty if HOME
/// is not set.
std::filesystem::path thumbnailFolder();

/// The state of a scene's picture.
struct Thumbnail {
    enum class State {
        missing,  ///< not made yet, or out of date
        ready,
        failed  ///< the scene has an error; there is no picture until one of its files changes
    };
    State state = State::missing;
    std::filesystem::path picture;  ///< PNG, if ready
    std::string problem;            ///< why it failed
};

/// Looks up the cache. A file is only read if its time has changed while its size has not.
Thumbnail findThumbnail(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// Draws the scene without a window and caches its picture or its failure.
Thumbnail makeThumbnail(gpu::Context& context, const std::filesystem::path& folder,
                        const std::filesystem::path& scene,
                        const std::vector<std::filesystem::path>& libraryRoots);

/// Caches a failure that is valid until the scene's own file changes: for a scene that cannot be drawn to the
/// end.
void rememberFailure(const std::filesystem::path& folder, const std::filesystem::path& scene,
                     const std::string& problem);

}  // namespace glibra::view
