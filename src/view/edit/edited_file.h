#pragma once
// A text file as an editor holds it: what the user has typed, and what the disk has.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "view/edit/text_history.h"

namespace glibra::view {

class EditedFile {
  public:
    /// Reads the file.
    explicit EditedFile(std::filesystem::path path);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// UTF-8, lines ended by LF, without a byte order mark: for a widget to show and change.
    [[nodiscard]] const std::string& text() const { return text_; }
    std::string& text() { return text_; }
    /// Why the text cannot be edited here, as a sentence; empty if it can.
    [[nodiscard]] const std::string& whyReadOnly() const { return whyReadOnly_; }
    /// True if the text is not what the file has.
    [[nodiscard]] bool isChanged() const { return whyReadOnly_.empty() && text_ != savedText_; }
    /// True if somebody else has changed the file since the text was taken from it, and so has the user.
    /// keepMine() or takeDisk() decide.
    [[nodiscard]] bool hasConflict() const { return hasConflict_; }

    /// Compares with the disk. What has changed there is taken over, unless the user has changed the text
    /// too. True if the text is another one now, or a conflict arose.
    bool lookAtDisk();
    /// The text stays; the next save replaces what is on the disk.
    void keepMine();
    /// The text is that of the disk; what was typed is lost.
    void takeDisk();
    /// The text as it was read or saved last.
    void revert();
    /// What was typed into it, and every other text that it has had. Whoever changes text() records it.
    TextHistory& history() { return history_; }
    /// Writes the file, whole or not at all, with the line ends, mark and encoding it had. If the disk has
    /// something that the user has not seen, nothing is written: hasConflict() is true then.
    Diagnostics save();

  private:
    void decode(std::string_view bytes);
    [[nodiscard]] std::string encoded() const;
    /// The bytes on the disk now; false if there are none to be had.
    bool readBytes(std::string& bytes);
    /// The text has become another one at once.
    void recordWhole();

    std::filesystem::path path_;
    std::string text_, savedText_;
    std::string diskBytes_;  ///< when last looked at and understood
    std::string whyReadOnly_;
    TextHistory history_{std::string()};
    bool hasMark_ = false, hasCarriageReturns_ = false, isLatin_ = false, hasConflict_ = false;
};

}  // namespace glibra::view
