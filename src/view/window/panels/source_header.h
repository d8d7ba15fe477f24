#pragma once
// What stands above the text in the source panel: the tabs of the files, and the buttons.

#include <filesystem>
#include <string>

#include "view/edit/edited_file.h"
#include "view/window/panels/source_state.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

/// "below the picture".
const char* nameOfPlace(SourcePlace place);

struct Ui;

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
