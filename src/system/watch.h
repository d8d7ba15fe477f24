#pragma once
// What happens to the names in folders.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glibra::system {

/// An event about a name in a watched folder, or about the folder itself.
struct FolderEvent {
    enum class What {
        written,  ///< a file was written and closed
        made,  ///< a name is new: a folder, a link, a further name of a file, or a file that will be written
        movedIn,     ///< a file was renamed to this name, whole
        removed,     ///< the name is gone
        folderGone,  ///< the folder itself is another one now, or is gone
        lost         ///< more happened than could be reported; `folder` and `name` are empty
    };
    What what{};
    int folder = -1;  ///< the number that add() gave
    std::string name{};
};

/// Watches folders, not what is in their sub-folders. All functions but interrupt() are called on one thread
/// at a time.
class FolderWatch {
  public:
    FolderWatch();
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;
    ~FolderWatch();
    /// False where the system cannot report changes.
    explicit operator bool() const;

    /// Watches a folder, which must not be a link. The number is the same for a folder that is watched
    /// already; nothing if it does not exist or cannot be watched.
    std::optional<int> add(const std::filesystem::path& folder);
    void remove(int folder);

    enum class Waited { events, nothing, interrupted };
    /// Waits for events, at most so long; -1: for ever. May be called while another thread uses the other
    /// functions.
    Waited wait(int milliseconds);
    /// The events so far, in their order.
    std::vector<FolderEvent> take();
    /// Ends a wait() on another thread, and all later ones. False if it cannot.
    bool interrupt();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::system
