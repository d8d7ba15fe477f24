#pragma once
// Small pictures of scenes, cached between runs. A picture is valid as long as the scene and all files that
// it was made from have the same content.

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "gpu/context/context.h"
#include "system/child_process.h"

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

// Makes the pictures of scenes while the window stays usable: it runs this program again, as a process
// without a window. If drawing a scene crashes or does not end, only that picture is missing.

class ThumbnailMaker {
  public:
    /// `wake` is called on another thread whenever takeFinished() has something new.
    ThumbnailMaker(std::filesystem::path folder, std::vector<std::filesystem::path> scenes,
                   std::function<void()> wake);
    ThumbnailMaker(const ThumbnailMaker&) = delete;
    ThumbnailMaker& operator=(const ThumbnailMaker&) = delete;
    /// Kills the process.
    ~ThumbnailMaker();

    /// The scenes that were finished since the last call. The cache has a picture or a failure for each.
    std::vector<std::filesystem::path> takeFinished();
    [[nodiscard]] bool hasFinished();

  private:
    void run();
    /// Makes the pictures of `scenes_` from index `first` until the process ends. Returns the index of the
    /// first scene that was not finished, and the reason in `why`.
    std::size_t runProcess(std::size_t first, const char*& why);
    void finish(std::size_t scene);

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> scenes_;
    std::function<void()> wake_;
    system::Waker stop_;
    std::mutex mutex_;
    std::vector<std::size_t> finished_;  ///< indices of scenes
    std::thread thread_;
};

/// The work of the process: makes the pictures of these scenes in order, and prints an empty line after each.
/// Returns the exit status.
int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots);

}  // namespace glibra::view
