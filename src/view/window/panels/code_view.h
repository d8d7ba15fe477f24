#pragma once
// What the code editor keeps for one text, and what is marked in it.

#include <glibra/diagnostic.h>

#include <optional>
#include <span>
#include <string>

#include "view/edit/text_search.h"
#include "view/edit/wrapped_text.h"

namespace glibra::view {

class EditedFile;

/// A message about a place; lines and columns are counted from 1, columns in bytes.
struct CodeMark {
    int line = 1, column = 1;
    Severity severity = Severity::error;
    std::string text;
};

/// The widget's state for one text, kept between frames.
struct CodeView {
    int line = 1, column = 1;  ///< of the cursor; columns count characters
    bool isActive = false;     ///< the widget has the keyboard focus
    // Requests for the next frame:
    std::optional<int> goTo;             ///< scroll to this line and put the cursor there
    bool leavesListKeys = false;         ///< Up, Down, Enter and Tab are for a list beside the text
    std::optional<TextRange> select;     ///< scroll to this range, select it and take the keyboard focus
    std::optional<std::size_t> reveal;   ///< scroll to this byte, without taking the keyboard focus
    std::optional<std::string> newText;  ///< replace the text by this one
    // State:
    std::optional<std::size_t> hovered;  ///< the byte under the mouse; nothing if the mouse is elsewhere
    std::optional<int> hoveredLine;      ///< the line under the mouse, also beside the text
    struct Corner {
        float x = 0, top = 0, bottom = 0;
    };
    Corner cursorOnScreen;  ///< screen coordinates
    /// Lines that are too long continue in further rows. Change it by Settings::wrapsLines.
    bool isWrapped = false;
    bool isAtEndOfRow = false;  ///< the cursor, where it could be at the beginning of the next one as well
    WrappedText wrapped;        ///< what the widget edits then
    std::string buffer;         ///< its rows, as the widget has changed them
    TextRange selection;        ///< empty, at the cursor, if nothing is selected
    int generation = 0;         ///< increase it whenever other code changes the text
    int cursor = 0;             ///< byte offset
    int cursorInRows = 0;       ///< the same in what the widget edits: `buffer` or the text
    int previousSize = 0;       ///< bytes of the text in the frame before
    float height = 0;           ///< of the visible part, pixels
    struct Scroll {
        float x = 0, y = 0;
    };
    Scroll scroll;           ///< pixels
    int framesToHold = 0;    ///< frames in which `scroll` stays, whatever else scrolls
    int framesToFollow = 0;  ///< frames in which the text still scrolls to the cursor, after a change
};

/// What is marked in a text.
struct CodeMarks {
    std::span<const CodeMark> lines;
    std::span<const TextRange> found;
    std::size_t shown = 0;  ///< index in `found` of the match to emphasise
};

/// The text that the source panel shows; both are null while it shows none.
struct ShownText {
    EditedFile* file = nullptr;
    CodeView* view = nullptr;
};

}  // namespace glibra::view
