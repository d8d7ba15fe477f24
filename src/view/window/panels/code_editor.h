#pragma once
// A widget that edits code, with line numbers, syntax colours and marked lines: what it keeps for one text,
// and what is marked in it.

#include <glibra/diagnostic.h>
#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "view/edit/source_files.h"
#include "view/edit/source_lines.h"

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

/// Draws the widget in the rest of the current window, except for `below` pixels at its lower edge. `name`
/// must be unique in the window. `wraps`: lines that are too long continue in further rows. Returns true if
/// the text has changed.
bool codeEditor(const char* name, std::string& text, CodeView& view, const CodeMarks& marks,
                CodeLanguage language, bool isReadOnly, float below, bool wraps);

// Draws the code of the code editor: line numbers, colours, marks and the cursor.

/// Byte offsets of the first characters of all lines, or of all rows.
using LineStarts = std::vector<std::size_t>;

/// A text with its lines, and the rows in which they are shown. Rows that continue a line do not begin after
/// a line feed.
struct CodeText {
    std::string_view text;
    LineStarts lines, rows;
    /// The line feed at the end of the row, or where the next row begins.
    [[nodiscard]] std::size_t endOfRow(int row) const;
    /// The row of the cursor, which may stand at the end of one that the next row continues.
    [[nodiscard]] int rowOfCursor(const CodeView& view) const;
};
LineStarts lineStarts(std::string_view text);
/// The line or row of a byte, counted from 1.
int lineOf(const LineStarts& starts, std::size_t byte);
/// The part of a byte's line or row that is before the byte.
std::string_view lineBefore(std::string_view text, const LineStarts& starts, std::size_t byte);

/// The width of a text in pixels, in the current font.
float widthOf(std::string_view text);

/// The positions of the code on the screen, in pixels.
struct CodeLayout {
    ImVec2 origin;  ///< of the first character
    ImVec2 size;    ///< of the whole text, at least the visible part
    float gutter = 0, lineHeight = 0, visibleHeight = 0;
    int fitting = 1;                ///< rows that fit into the visible part
    int firstRow = 1, lastRow = 1;  ///< the visible rows
    [[nodiscard]] float top(int row) const { return origin.y + static_cast<float>(row - 1) * lineHeight; }
};

/// The width of the line numbers.
float gutterOf(const LineStarts& lines);
/// The breaks of lines that are too wide for a window of that width, in pixels (breaksOf).
std::vector<std::size_t> breaksIn(std::string_view text, float width);
/// The text in rows that begin at all lines and those breaks.
CodeText codeOf(std::string_view text, const std::vector<std::size_t>& breaks);
/// The layout in the rest of the current window, at its current scroll position.
CodeLayout layoutOf(const CodeText& code, bool isWrapped);

/// Draws the visible rows into the current window.
void drawCode(const CodeLayout& layout, const CodeText& code, const CodeView& view, const CodeMarks& marks,
              CodeLanguage language);

}  // namespace glibra::view
