#pragma once
// Draws the code of the code editor: line numbers, colours, marks and the cursor.

#include <imgui.h>

#include <string_view>
#include <vector>

#include "view/edit/source_files.h"
#include "view/window/panels/code_view.h"

namespace glibra::view {

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
