#pragma once
// Draws the code of the code editor: line numbers, colours, marks and the cursor.

#include <imgui.h>

#include <string_view>
#include <vector>

#include "view/edit/syntax.h"
#include "view/window/panels/code_view.h"

namespace glibra::view {

/// Byte offsets of the first characters of all lines.
using LineStarts = std::vector<std::size_t>;
LineStarts lineStarts(std::string_view text);
/// The line of a byte, counted from 1.
int lineOf(const LineStarts& starts, int byte);
/// The part of a byte's line that is before the byte.
std::string_view lineBefore(std::string_view text, const LineStarts& starts, std::size_t byte);

/// The width of a text in pixels, in the current font.
float widthOf(std::string_view text);

/// The positions of the code on the screen, in pixels.
struct CodeLayout {
    ImVec2 origin;  ///< of the first character
    ImVec2 size;    ///< of the whole text, at least the visible part
    float gutter = 0, lineHeight = 0, visibleHeight = 0;
    int rows = 1;                     ///< lines that fit into the visible part
    int firstLine = 1, lastLine = 1;  ///< the visible lines
    [[nodiscard]] float top(int line) const { return origin.y + static_cast<float>(line - 1) * lineHeight; }
};

/// The layout in the rest of the current window, at its current scroll position.
CodeLayout layoutOf(std::string_view text, const LineStarts& starts);

/// Draws the visible lines into the current window.
void drawCode(const CodeLayout& layout, std::string_view text, const LineStarts& starts, const CodeView& view,
              const CodeMarks& marks, CodeLanguage language);

}  // namespace glibra::view
