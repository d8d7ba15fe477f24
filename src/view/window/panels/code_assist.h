#pragma once
// Help while code is written: the list of words that may stand at the cursor, what a name under the mouse is,
// and a window with the entry of a word in the reference.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "view/edit/source_files.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/code_editor.h"

namespace glibra::view {

struct Ui;

struct CodeAssist {
    // The list of words.
    bool isOpen = false;
    bool isAsked = false;  ///< it opens in the next frame
    std::vector<Completion> words;
    std::size_t chosen = 0;
    bool hasMoved = false;  ///< the arrow keys have chosen
    TextRange typed;        ///< what an accepted word replaces
    int cursor = 0;         ///< the cursor for which the list was made
    bool hasAccepted = false;
    // The arguments of what is called at the cursor, while one types there.
    bool isHinting = false;
    CallHint hint;
    // What the mouse is on.
    std::size_t hovered = 0;
    double hoveredSince = 0;  ///< ImGui::GetTime()
    ReferenceEntry hoveredEntry;
    // The reference.
    bool showsReference = false, focusEntry = false;
    ReferenceEntry entry;
    std::vector<Completion> overview;  ///< the words to choose from, while there is no entry
    std::array<char, 128> word{};
    CodeLanguage language = CodeLanguage::glsl;
};

/// Handles the keys of the list. Call it before the text is drawn.
void assistKeys(CodeAssist& state, EditedFile& file, CodeView& view);
/// Updates and draws the list and the text about the name under the mouse. `isChanged`: the text has changed
/// in this frame. Call it after the text was drawn.
void assist(Ui& ui, CodeAssist& state, EditedFile& file, CodeView& view, bool isChanged);
/// The window with the entry of a word. `file`: the one that the source panel shows or showed last; may be
/// null.
void referenceWindow(Ui& ui, CodeAssist& state, const EditedFile* file);

// Shortcuts. `active`: the text that has the keyboard focus.
void commentLines(const Ui& ui, const ShownText& active);
/// Tab and Shift+Tab, unless they choose from the list of words.
void indentLines(const CodeAssist& state, const ShownText& active, bool back);
/// Opens the entry of the word at the cursor or before it; without one a list of words.
void showReference(const Ui& ui, CodeAssist& state, const ShownText& active, const EditedFile* file);
/// Closes the list of words, the arguments, or the reference. Returns false if none was open.
bool closeAssist(CodeAssist& state);

}  // namespace glibra::view
