#pragma once
// A text file in an editor: the text that the user edits, and what is on the disk.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

// Undo and redo of edits of a text.

class TextHistory {
  public:
    /// Starts with the initial text.
    explicit TextHistory(std::string text) : present_(std::move(text)) {}

    /// Records the text after a change of any kind. A change that continues the last one, as the letters of a
    /// word do, joins its step.
    void record(std::string_view text);
    /// The next change begins a new step.
    void endStep() { mayJoin_ = false; }

    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ < steps_.size(); }
    /// A text, and the byte offset of the cursor: after the change.
    struct State {
        std::string text;
        std::size_t cursor = 0;
    };
    /// Undoes or redoes one step and returns the text after that. Without such a step it returns the current
    /// text.
    State undo();
    State redo();

    static constexpr std::size_t kMostSteps = 2000;

  private:
    /// `removed` was replaced by `added`, at byte `begin`.
    struct Step {
        std::size_t begin = 0;
        std::string removed, added;
    };
    bool join(const Step& step);

    std::string present_;
    std::vector<Step> steps_;
    std::size_t at_ = 0;  ///< steps before it are done, the others are undone
    bool mayJoin_ = false;
};

class EditedFile {
  public:
    /// Reads the file.
    explicit EditedFile(std::filesystem::path path);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// The text to show and edit: UTF-8, lines end with LF, no byte order mark.
    [[nodiscard]] const std::string& text() const { return text_; }
    std::string& text() { return text_; }
    /// A sentence that says why the text cannot be edited; empty if it can.
    [[nodiscard]] const std::string& whyReadOnly() const { return whyReadOnly_; }
    /// True if the text is not on the disk: it has changes that are not saved, or the file is gone.
    [[nodiscard]] bool isChanged() const { return whyReadOnly_.empty() && (isGone_ || text_ != savedText_); }
    /// True if the file was removed after it was read. save() writes it again.
    [[nodiscard]] bool isGone() const { return isGone_; }
    /// True if both the user and another program have changed the file since it was last read. keepMine() or
    /// takeDisk() resolves the conflict.
    [[nodiscard]] bool hasConflict() const { return hasConflict_; }

    /// Compares with the file on the disk. If it has changed there, it is read again, unless the user has
    /// changed the text too: then there is a conflict. Returns true if the text has changed or a conflict
    /// arose.
    bool lookAtDisk();
    /// Keeps the text; the next save overwrites the file on the disk.
    void keepMine();
    /// Reads the file from the disk; unsaved changes are lost.
    void takeDisk();
    /// Restores the text that was last read or saved.
    void revert();
    /// The undo history. Record every change of text() here.
    TextHistory& history() { return history_; }
    /// Writes the file atomically, with the line ends, byte order mark and encoding that it had. If another
    /// program has changed it meanwhile, nothing is written and hasConflict() is true.
    Diagnostics save();
    /// Writes other bytes into the file, for a change that is not typed. Text that is not saved gets the
    /// lines that change, too, and stays unsaved. Nothing is written if it has not these lines as the file
    /// has them, or if another program has changed the file meanwhile: view-E01.
    Diagnostics changeFile(const std::string& bytes);

  private:
    void decode(std::string_view bytes);
    [[nodiscard]] std::string encoded() const;
    /// Reads the file from the disk. Returns false if it cannot be read.
    bool readBytes(std::string& bytes);
    /// Records a change of the whole text as one undo step.
    void recordWhole();

    std::filesystem::path path_;
    std::string text_, savedText_;
    std::string diskBytes_;  ///< what the file had when it was last read or saved
    std::string whyReadOnly_;
    TextHistory history_{std::string()};
    bool hasMark_ = false, hasCarriageReturns_ = false, isLatin_ = false, hasConflict_ = false,
         isGone_ = false;
};

// The folders of the scenes, shaders, textures and models that ship with glibra.

/// The folder with the examples: the first of `roots` that is a library, or else the nearest library above
/// the program, or else above the scene (base/own_library.h). Empty if there is none.
std::filesystem::path exampleRoot(const std::vector<std::filesystem::path>& roots,
                                  const std::filesystem::path& scene, const std::filesystem::path& program);

/// True for the scenes, shaders, textures and models that ship with the running program, and for any other
/// file in their folders, whether it exists or not. They are not written to.
bool isExample(const std::filesystem::path& file);
/// view-E03 if the file may not be written, because it is in such a folder.
Diagnostics writingProblem(const std::filesystem::path& file);

// Opens a file in the user's own editor.

/// Starts $VISUAL or $EDITOR, or else the editor that the system has, at that line without waiting for it, in
/// a terminal if the editor needs one. Returns a message for the status line: what was opened, or why it
/// failed.
std::string openInEditor(const Place& place);

}  // namespace glibra::view
