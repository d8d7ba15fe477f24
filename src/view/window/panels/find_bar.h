#pragma once
// The bar above the text of the source panel: find, replace and go to a line. Also undo in that text.

#include <array>
#include <string>
#include <vector>

#include "view/edit/text_search.h"
#include "view/window/panels/code_view.h"

namespace glibra::view {

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

}  // namespace glibra::view
