#pragma once
// The state of the source panel, and what stands above its text: the tabs of the files, the buttons, and the
// bar that finds and replaces.

#include <glibra/diagnostic.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "view/edit/edited_file.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/code_assist.h"
#include "view/window/panels/code_editor.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

// The bar above the text of the source panel: find, replace and go to a line. Also undo in that text.

struct Ui;

struct FindBar {
    bool isOpen = false, replaces = false, asksLine = false;
    bool focus = false;  ///< the text field needs the keyboard focus
    std::array<char, 256> words{}, by{};
    int line = 1;
    bool matchesCase = false, wholeWords = false;
    TextSearch search;             ///< the search that gave `found`
    std::vector<TextRange> found;  ///< matches in the shown text
    std::size_t shown = 0;         ///< index of the current match
    std::size_t from = 0;          ///< byte at which a new search begins
};

/// Searches the text for the words in the bar, and draws the bar.
void findBar(Ui& ui, FindBar& bar, EditedFile& file, CodeView& view);

// Shortcuts. While no text is shown, openFind() opens the bar, and the others do nothing.
void openFind(FindBar& bar, const ShownText& shown, bool replaces);
void askLine(FindBar& bar, const ShownText& shown);
/// Goes to the next or previous match; opens the bar if there was no search yet.
void findAgain(FindBar& bar, const ShownText& shown, bool backwards);
/// Closes the bar. Returns false if it was not open.
bool closeFind(FindBar& bar, const ShownText& shown);
/// Undo (or redo, with `again`) in the text.
void undoTyping(const ShownText& shown, bool again);

/// What is shown now.
struct ShownSource {
    std::string file;  ///< empty: no text
    int line = 0, column = 0;
    bool isActive = false, isChanged = false, hasConflict = false;
};

struct SourceState {
    ShownSource shown;
    std::uint64_t loaded = 0;      ///< Session::timesLoaded() of Ui::files
    std::filesystem::path chosen;  ///< one of them
    bool follow = false;           ///< the file tabs have to select `chosen`
    std::optional<Place> goTo;     ///< a place to show in this frame
    std::map<std::filesystem::path, CodeView> views;
    FindBar find;
    CodeAssist assist;
    /// Texts that are not saved and will be compiled when the user pauses, and since when they are so.
    std::map<std::filesystem::path, std::string> typedTexts;
    double typedAt = 0;          ///< ImGui::GetTime()
    bool keepsKeyboard = false;  ///< the text had the keyboard last, and nothing was clicked since but
                                 ///< windows that Esc closes
};

/// "below the picture".
const char* nameOfPlace(SourcePlace place);

/// True if both name the same file.
bool isSame(const std::filesystem::path& a, const std::filesystem::path& b);
void fileTabs(Ui& ui, SourceState& panel);
void sourceButtons(Ui& ui, const SourceState& panel, EditedFile& file, CodeView& view);
/// What to do about a change that another program has made.
void conflict(Ui& ui, EditedFile& file, CodeView& view);
/// What to do with a text that an earlier run of the window has kept.
void recovered(Ui& ui, EditedFile& file, CodeView& view);
/// Replaces the whole text, which is one step of undo.
void replaceText(EditedFile& file, std::string text);
/// What the status line says after a file was saved.
std::string savedNotice(const std::filesystem::path& file);
/// Saves the file that is shown.
void saveSource(Ui& ui, const std::filesystem::path& chosen);
/// Saves all files with text that is not saved, up to the first that cannot be.
void saveAllSources(Ui& ui);
/// Restores the text that was last read or saved.
void revertSource(EditedFile& file, CodeView& view);
/// Opens the file at the cursor's line in the user's own editor.
void openShown(Ui& ui, const EditedFile& file, const CodeView& view);

}  // namespace glibra::view
