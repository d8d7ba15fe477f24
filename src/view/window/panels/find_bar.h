#pragma once
// The bar above the text of the source panel: find, replace and go to a line. Also undo in that text.

#include <array>
#include <string>
#include <vector>

#include "view/edit/text_search.h"
#include "view/window/panels/code_editor.h"

namespace glibra::view {

struct Ui;
class EditedFile;

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
void findBar(Ui& ui, EditedFile& file, CodeView& view);

// Shortcuts. If the source panel is hidden, openFind() shows it, and the others do nothing.
void openFind(Ui& ui, bool replaces);
void askLine(Ui& ui);
/// Goes to the next or previous match; opens the bar if there was no search yet.
void findAgain(Ui& ui, bool backwards);
/// Closes the bar. Returns false if it was not open.
bool closeFind(Ui& ui);
/// Undo (or redo, with `again`) in the text, while it has the keyboard focus.
void undoTyping(Ui& ui, bool again);

}  // namespace glibra::view
