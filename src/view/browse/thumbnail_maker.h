#pragma once
// Makes the pictures of scenes while the window stays usable: it runs this program again, as a process
// without a window. If drawing a scene crashes or does not end, only that picture is missing.

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace glibra::view {

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
    int stop_ = -1;
    std::mutex mutex_;
    std::vector<std::size_t> finished_;  ///< indices of scenes
    std::thread thread_;
};

/// The work of the process: makes the pictures of these scenes in order, and prints an empty line after each.
/// Returns the exit status.
int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots);

}  // namespace glibra::view
