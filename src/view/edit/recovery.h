#pragma once
// Texts that are not saved, kept in files for the case that the program ends unexpectedly.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "system/file.h"

namespace glibra::view {

/// $XDG_STATE_HOME/glibra, by default ~/.local/state/glibra. Empty if HOME is not set.
std::filesystem::path stateFolder();

/// A text that was not saved.
struct RecoveredText {
    std::string text;
    std::string when;            ///< it was kept: "2026-03-01 14:05", local time
    std::filesystem::path copy;  ///< the file that keeps it
    std::int64_t written;  ///< the same time exactly: files may share a time of the file system; 0: unknown
};

/// The copies that one window keeps, in `folder`/unsaved. A copy belongs to the window that has written it,
/// which holds a lock in `folder`/windows as long as its process lives; no other window takes it away before.
/// Errors are ignored: there is no copy then.
class SafetyCopies {
  public:
    explicit SafetyCopies(std::filesystem::path folder) : folder_(std::move(folder)) {}
    SafetyCopies(const SafetyCopies&) = delete;
    SafetyCopies& operator=(const SafetyCopies&) = delete;
    /// Gives the lock back. The copies stay.
    ~SafetyCopies();

    /// Writes the text of a file in place of the one from before.
    void keep(const std::filesystem::path& file, const std::string& text);
    /// Removes what keep() has written.
    void forget(const std::filesystem::path& file);
    void forgetAll();
    /// True if the copy is where keep() has written it.
    [[nodiscard]] bool isKept(const std::filesystem::path& file) const;
    /// The paths of the copies, and how often they have become others.
    [[nodiscard]] const std::vector<std::filesystem::path>& copies() const { return copies_; }
    [[nodiscard]] std::uint64_t timesChanged() const { return timesChanged_; }

    /// What other windows have of a file.
    struct Others {
        std::optional<RecoveredText> left;  ///< the newest copy of a window that has ended
        bool isOpen = false;                ///< a window that still runs has text that is not saved
    };
    [[nodiscard]] Others othersOf(const std::filesystem::path& file) const;
    /// Removes the copy of a window that has ended.
    static void remove(const RecoveredText& text);

  private:
    bool own();
    [[nodiscard]] std::filesystem::path copyOf(const std::filesystem::path& file) const;
    [[nodiscard]] bool isAlive(const std::string& owner) const;

    std::filesystem::path folder_;
    std::string owner_;  ///< names the lock; empty: there is none yet
    system::Lock lock_;
    std::vector<std::filesystem::path> copies_;
    std::uint64_t timesChanged_ = 0;
};

}  // namespace glibra::view
