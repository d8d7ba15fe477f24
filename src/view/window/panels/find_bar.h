#pragma once
// Find, replace and go to a line, above the text of the source panel; undo in it.

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
    bool focus = false;  ///< the entry has to get the keyboard
    std::array<char, 256> words{}, by{};
    int line = 1;
    bool matchesCase = false, wholeWords = false;
    TextSearch search;             ///< that `found` comes from
    std::vector<TextRange> found;  ///< in the text that is shown
    std::size_t shown = 0;         ///< index into it
    std::size_t from = 0;          ///< byte from which a new search begins
};

/// Looks for what the bar says in the text as it is now, and draws the bar.
void findBar(Ui& ui, EditedFile& file, CodeView& view);

// Keys. Without a source panel that is shown the first two show it, and the others do nothing.
void openFind(Ui& ui, bool replaces);
void askLine(Ui& ui);
/// The next place, or the one before; opens the bar if nothing has been looked for yet.
void findAgain(Ui& ui, bool backwards);
/// False if there was nothing to close.
bool closeFind(Ui& ui);
/// Undo and redo in the text, while it has the keyboard.
void undoTyping(Ui& ui, bool again);

}  // namespace glibra::view
