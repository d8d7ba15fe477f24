#pragma once
// Tells when files of a scene were saved. Folders are watched, not files, so that editors that save under
// another name and rename are seen too, and a file is only reported when its writer has closed it.

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace glibra::view {

class FileWatch {
  public:
    /// `wake` is called on another thread whenever takeChanged() has something new.
    explicit FileWatch(std::function<void()> wake);
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;
    ~FileWatch();

    /// From now on these files count, and files of these names that appear in any of their folders.
    void watch(const std::vector<std::filesystem::path>& files, const std::set<std::string>& names);

    struct Change {
        std::vector<std::filesystem::path> files;
        std::chrono::steady_clock::time_point saved;  ///< when the first of them was told
    };
    /// What was saved since the last call; no files if nothing was.
    Change takeChanged();
    /// False where the system does not tell of changes; then nothing ever comes.
    [[nodiscard]] bool isWorking() const { return inotify_ >= 0; }

  private:
    void run();
    /// True if an event of a file that counts was among those read.
    bool readEvents();

    std::function<void()> wake_;
    int inotify_ = -1;
    int stop_ = -1;
    std::mutex mutex_;
    std::map<int, std::filesystem::path> folders_;  ///< by watch descriptor
    std::set<std::filesystem::path> files_;
    std::set<std::string> names_;
    Change changed_;
    std::thread thread_;
};

}  // namespace glibra::view
