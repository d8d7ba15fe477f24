#pragma once
// Reports when files of a scene are saved, removed or made. It watches the folders through which the paths of
// the files lead, not the files, so that it also sees editors that save under another name and rename, and
// folders and links that are replaced: by `git checkout`, by unpacking an archive, by `ln -sfn`. A file is
// reported only after its writer has closed it, and a removed one only if it does not come back at once: some
// programs move a file away before they write it.

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "system/file.h"
#include "system/watch.h"

namespace glibra::view {

class FileWatch {
  public:
    /// `wake` is called on another thread whenever takeChanged() has something new.
    explicit FileWatch(std::function<void()> wake);
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;
    ~FileWatch();

    /// Replaces the list of watched files. They need not exist, nor need their folders; one that does not is
    /// also reported if it is made with another case. Files that were reported as removed stay watched.
    void watch(const std::vector<std::filesystem::path>& files);

    struct Change {
        /// As absolute paths of what watch() was given.
        std::vector<std::filesystem::path> files;
        std::chrono::steady_clock::time_point saved;  ///< when the first of them was noticed
    };
    /// The files saved, made or removed since the last call; empty if there are none.
    Change takeChanged();
    /// False where the system cannot report changes. Then takeChanged() always returns no files.
    [[nodiscard]] bool isWorking() const { return thread_.joinable(); }

  private:
    using Identity = system::FileIdentity;
    /// What the name in a folder means for the watched files.
    struct Name {
        std::set<std::filesystem::path> files;  ///< those whose paths end there
        bool isPassed = false;                  ///< a folder or link on the way to one
    };
    enum class Seen { nothing, saved, moved };

    void run();
    /// Reads all pending events. Returns true if one of them is about a watched file that was saved.
    bool readEvents();
    Seen readEvent(const system::FolderEvent& event);
    /// Finds the folders through which the paths lead now, and watches them.
    void findWays();
    void findWay(const std::filesystem::path& file, std::set<std::filesystem::path>& folders);
    /// The same after a folder or a link was replaced. Returns true if files are others than before.
    bool followWays();
    void noteSaved(const std::filesystem::path& file);
    /// Reports removed files that have stayed away long enough. Returns true if there is one.
    bool reportRemoved();
    /// Until the next removed file is to be reported; -1: there is none.
    int millisecondsToRemoved();

    std::function<void()> wake_;
    system::FolderWatch watch_;
    std::mutex mutex_;
    std::map<std::filesystem::path, Identity> files_;
    std::map<int, std::filesystem::path> folders_;  ///< without links, by their numbers of watch_
    std::map<std::filesystem::path, Name> names_;   ///< by their paths in these folders
    std::map<std::string, Name> missing_;           ///< the same for files that are missing, in lower case
    /// When each file was removed that may still come back.
    std::map<std::filesystem::path, std::chrono::steady_clock::time_point> removed_;
    std::set<std::filesystem::path> gone_;  ///< files that were reported as removed
    Change changed_;
    std::thread thread_;
};

}  // namespace glibra::view
