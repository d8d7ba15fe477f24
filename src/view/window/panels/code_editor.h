#pragma once
// A widget for the text of a program: line numbers, colours, marked lines.

#include <glibra/diagnostic.h>

#include <optional>
#include <span>
#include <string>

#include "view/edit/code_paint.h"
#include "view/edit/text_search.h"

namespace glibra::view {

/// A message about a line, counted from 1.
struct CodeMark {
    int line = 1;
    Severity severity = Severity::error;
    std::string text;
};

/// What the widget keeps of one text from frame to frame.
struct CodeView {
    int line = 1, column = 1;         ///< of the cursor; columns count characters
    bool isActive = false;            ///< it has the keyboard
    std::optional<int> goTo;          ///< a line that is to be shown, and to get the cursor
    std::optional<TextRange> select;  ///< a part that is to be shown and selected, with the keyboard's focus
    std::optional<std::size_t> reveal;   ///< a byte that is to be shown; the keyboard stays where it is
    std::optional<std::string> newText;  ///< that is to take the place of the text
    TextRange selection;                 ///< of the cursor; empty where nothing is selected
    int generation = 0;                  ///< counted up when somebody else than the widget changes the text
    int cursor = 0, previousSize = 0;    ///< bytes
    float height = 0;                    ///< of what was seen
    struct Scroll {
        float x = 0, y = 0;
    };
    Scroll scroll;         ///< pixels
    int framesToHold = 0;  ///< for which it stays whatever else scrolls
};

/// What is shown in a text besides the text.
struct CodeMarks {
    std::span<const CodeMark> lines;
    std::span<const TextRange> found;
    std::size_t shown = 0;  ///< index of the one among `found` that stands out
};

/// Fills what is left of the current window but `below` pixels. True if the text has changed. `name` tells
/// widgets apart.
bool codeEditor(const char* name, std::string& text, CodeView& view, const CodeMarks& marks, Dialect dialect,
                bool isReadOnly, float below);

}  // namespace glibra::view
