#pragma once
// Pictures of scenes, made while the window stays usable: by this program once more, as a process without a
// window. A scene whose drawing crashes or does not end costs only its own picture.

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
    /// Ends the process.
    ~ThumbnailMaker();

    /// The scenes that the cache has a picture or a failure of since the last call.
    std::vector<std::filesystem::path> takeFinished();
    [[nodiscard]] bool hasFinished();

  private:
    void run();
    /// Makes the pictures of `scenes_` from number `first` on until the process ends; returns the number of
    /// the first scene that was not finished.
    std::size_t runProcess(std::size_t first, std::string& why);
    void finish(std::size_t scene);

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> scenes_;
    std::function<void()> wake_;
    int stop_ = -1;
    std::mutex mutex_;
    std::vector<std::filesystem::path> finished_;
    std::thread thread_;
};

/// What the process does: the pictures of these scenes, in order; a line on standard output after each.
/// Returns the exit status.
int makeThumbnails(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& scenes,
                   const std::vector<std::filesystem::path>& libraryRoots);

}  // namespace glibra::view
