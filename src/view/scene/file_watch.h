#pragma once
// Reports when files of a scene are saved or removed. It watches folders, not files, so that it also sees
// editors that save under another name and rename. A file is reported only after its writer has closed it,
// and a removed one only if it does not come back at once: some editors move a file away before they write
// it.

#include <chrono>
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

    /// Replaces the list of watched files. Files with one of `names` are also reported when they appear in
    /// the folder of a watched file: these are files that a scene names and that are missing. Files that were
    /// reported as removed stay watched.
    void watch(const std::vector<std::filesystem::path>& files, const std::set<std::string>& names);

    struct Change {
        std::vector<std::filesystem::path> files;
        std::chrono::steady_clock::time_point saved;  ///< when the first of them was noticed
    };
    /// The files saved or removed since the last call; empty if there are none.
    Change takeChanged();
    /// False where the system cannot report changes. Then takeChanged() always returns no files.
    [[nodiscard]] bool isWorking() const { return thread_.joinable(); }

  private:
    void run();
    /// Reads all pending events. Returns true if one of them is about a watched file that was saved.
    bool readEvents();
    void noteSaved(const std::filesystem::path& file);
    /// Reports removed files that have stayed away long enough. Returns true if there is one.
    bool reportRemoved();
    /// Until the next removed file is to be reported; -1: there is none.
    int millisecondsToRemoved();

    std::function<void()> wake_;
    int inotify_ = -1;
    int stop_ = -1;
    std::mutex mutex_;
    std::map<int, std::filesystem::path> folders_;  ///< by watch descriptor
    std::set<std::filesystem::path> files_;
    std::set<std::string> names_;
    /// When each file was removed that may still come back.
    std::map<std::filesystem::path, std::chrono::steady_clock::time_point> removed_;
    std::set<std::filesystem::path> gone_;  ///< files that were reported as removed
    Change changed_;
    std::thread thread_;
};

}  // namespace glibra::view
