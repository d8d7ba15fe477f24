#pragma once
// Small pictures of scenes, kept between runs. A picture counts as long as the scene and every file that it
// was made from have the content they had then.

#include <filesystem>
#include <string>
#include <vector>

#include "gpu/context.h"

namespace glibra::view {

inline constexpr int kThumbnailWidth = 320;
inline constexpr int kThumbnailHeight = 240;

/// $XDG_CACHE_HOME/glibra/thumbnails, by default ~/.cache/glibra/thumbnails; empty without a home.
std::filesystem::path thumbnailFolder();

/// What is known of a scene's picture.
struct Thumbnail {
    enum class State {
        missing,  ///< never made, or out of date
        ready,
        failed  ///< the scene has an error: until one of its files changes there is no picture
    };
    State state = State::missing;
    std::filesystem::path picture;  ///< PNG, if ready
    std::string problem;            ///< if failed
};

/// Looks into the cache; reads files only where their size or time is another one.
Thumbnail findThumbnail(const std::filesystem::path& folder, const std::filesystem::path& scene);

/// Draws the scene without a window and puts its picture, or its failure, into the cache.
Thumbnail makeThumbnail(gpu::Context& context, const std::filesystem::path& folder,
                        const std::filesystem::path& scene,
                        const std::vector<std::filesystem::path>& libraryRoots);

/// Puts a failure into the cache that holds until the scene's own file changes: for a scene whose drawing
/// never ended.
void rememberFailure(const std::filesystem::path& folder, const std::filesystem::path& scene,
                     const std::string& problem);

}  // namespace glibra::view
