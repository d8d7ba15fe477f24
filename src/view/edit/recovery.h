#pragma once
// Texts that are not saved, kept in files for the case that the program ends unexpectedly.

#include <filesystem>
#include <optional>
#include <string>

namespace glibra::view {

/// $XDG_STATE_HOME/glibra/unsaved, by default ~/.local/state/glibra/unsaved. Empty if HOME is not set.
std::filesystem::path recoveryFolder();

/// A text that was not saved.
struct RecoveredText {
    std::string text;
    std::string when;  ///< it was kept: "2026-03-01 14:05", local time
};

/// Writes the text of a file into the folder, in place of the one from before. Errors are ignored.
void keepText(const std::filesystem::path& folder, const std::filesystem::path& file,
              const std::string& text);
/// Removes what keepText() has written.
void forgetText(const std::filesystem::path& folder, const std::filesystem::path& file);
/// What keepText() has written, if there is any.
std::optional<RecoveredText> keptText(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace glibra::view
