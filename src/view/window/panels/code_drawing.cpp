#include "view/window/panels/code_editor.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/text.h"
#include "view/edit/source_lines.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

std::string_view lineText(const CodeText& code, int line) {
    const auto index = static_cast<std::size_t>(line - 1);
    const std::size_t begin = code.lines[index];
    const std::size_t end = index + 1 < code.lines.size() ? code.lines[index + 1] - 1 : code.text.size();
    return code.text.substr(begin, end - begin);
}

/// Fills a rectangle with a tint. Over the picture the panel lets a part of it be seen; below a tint it does
/// not, so that the text stays readable.
void drawTint(const ImVec2& low, const ImVec2& high, CodeTint tint, float rounding = 0) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, packed(palette().panel), rounding);
    draw.AddRectFilled(low, high, tintColor(tint), rounding);
}

/// The panel below the rows with selected text, which the widget tints.
void drawBelowSelection(const CodeLayout& layout, const CodeText& code, const TextRange& selection) {
    if (selection.begin == selection.end) return;
    const int first = std::max(layout.firstRow, lineOf(code.rows, selection.begin));
    const int last = std::min(layout.lastRow, lineOf(code.rows, selection.end));
    if (first > last) return;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {layout.origin.x, layout.top(first)},
        {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), layout.top(last) + layout.lineHeight},
        packed(palette().panel));
}

/// Calls `draw(left, right, top)` for the part of the range in each visible row.
template <class Draw>
void inRows(const CodeLayout& layout, const CodeText& code, const TextRange& range, Draw&& draw) {
    const int first = lineOf(code.rows, range.begin);
    const int last = std::max(first, lineOf(code.rows, range.end == 0 ? 0 : range.end - 1));
    for (int row = std::max(first, layout.firstRow); row <= std::min(last, layout.lastRow); ++row) {
        const std::size_t start = code.rows[static_cast<std::size_t>(row - 1)];
        const std::size_t begin = std::max(start, range.begin);
        const std::size_t end = std::max(begin, std::min(code.endOfRow(row), range.end));
        const float left = layout.origin.x + widthOf(code.text.substr(start, begin - start));
        draw(left, left + widthOf(code.text.substr(begin, end - begin)), layout.top(row));
    }
}

/// The word at the place that a message names, or one character.
TextRange markedPart(std::string_view line, int column) {
    const auto first = std::min(static_cast<std::size_t>(std::max(1, column)) - 1, line.size());
    const auto isOfWord = [&](std::size_t at) { return at < line.size() && base::isOfName(line[at]); };
    std::size_t end = first;
    while (isOfWord(end)) ++end;
    return {first, std::max(end, first + 1)};
}

/// A wave below a part of a row.
void underline(const CodeLayout& layout, float left, float right, float top, ImU32 color) {
    right = std::max(right, left + widthOf("0"));
    const float height = std::max(2.F, layout.lineHeight / 7);
    const float bottom = top + layout.lineHeight - 1;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    bool isUp = false;
    for (float x = left; x < right; x += height, isUp = !isUp) {
        const float to = std::min(x + height, right);
        draw.AddLine({x, isUp ? bottom - height : bottom}, {to, isUp ? bottom : bottom - height}, color,
                     1.5F);
    }
}

/// The rows of a line, the first and the last; nothing if the text has no such line.
std::optional<std::pair<int, int>> rowsOf(const CodeText& code, int line) {
    if (line < 1 || line > static_cast<int>(code.lines.size())) return std::nullopt;
    const auto index = static_cast<std::size_t>(line - 1);
    const std::size_t next = index + 1 < code.lines.size() ? code.lines[index + 1] - 1 : code.text.size();
    return std::pair{lineOf(code.rows, code.lines[index]), lineOf(code.rows, next)};
}

/// Tints the lines with messages, and marks them at the left edge. The messages themselves are in the list
/// below the text.
void drawMarkedLines(const CodeLayout& layout, const CodeText& code, std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    int lineBefore = 0;
    for (const CodeMark& each : marks) {
        const auto rows = rowsOf(code, each.line);
        if (!rows || rows->second < layout.firstRow || rows->first > layout.lastRow) continue;
        // The marks of a line follow each other, the worst one first.
        if (std::exchange(lineBefore, each.line) == each.line) continue;
        const bool isError = each.severity == Severity::error;
        const float top = layout.top(rows->first), bottom = layout.top(rows->second + 1);
        drawTint({window.x, top}, {window.x + ImGui::GetWindowWidth(), bottom},
                 isError ? CodeTint::errorLine : CodeTint::warningLine);
        draw.AddRectFilled({window.x, top}, {window.x + layout.lineHeight / 3, bottom},
                           packed(severityColor(each.severity)));
    }
}

void drawUnderlines(const CodeLayout& layout, const CodeText& code, std::span<const CodeMark> marks) {
    for (const CodeMark& each : marks) {
        const auto rows = rowsOf(code, each.line);
        if (!rows || rows->second < layout.firstRow || rows->first > layout.lastRow) continue;
        const TextRange part = markedPart(lineText(code, each.line), each.column);
        const std::size_t start = code.lines[static_cast<std::size_t>(each.line - 1)];
        inRows(layout, code, {start + part.begin, start + part.end}, [&](float left, float right, float top) {
            underline(layout, left, right, top, packed(severityColor(each.severity)));
        });
    }
}

/// The matches of a search.
void drawFound(const CodeLayout& layout, const CodeText& code, const CodeMarks& marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < marks.found.size(); ++i) {
        const TextRange& each = marks.found[i];
        if (each.end > code.text.size()) break;
        inRows(layout, code, each, [&](float left, float right, float top) {
            drawTint({left, top}, {right, top + layout.lineHeight},
                     i == marks.shown ? CodeTint::foundShown : CodeTint::found, 2);
            if (i == marks.shown)
                draw.AddRect({left - 1, top}, {right + 1, top + layout.lineHeight}, packed(palette().warning),
                             2);
        });
    }
}

void drawText(const CodeLayout& layout, const CodeText& code, CodeLanguage language) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    SyntaxReader syntax(language);
    const int first = lineOf(code.lines, code.rows[static_cast<std::size_t>(layout.firstRow - 1)]);
    const int last = lineOf(code.lines, code.rows[static_cast<std::size_t>(layout.lastRow - 1)]);
    for (int line = 1; line <= last; ++line) {
        const std::string_view words = lineText(code, line);
        const std::vector<SyntaxPiece> pieces = syntax.next(words);
        if (line < first) continue;
        const std::size_t start = code.lines[static_cast<std::size_t>(line - 1)];
        std::size_t drawn = 0;
        int row = lineOf(code.rows, start);
        ImVec2 at(layout.origin.x, layout.top(row));
        const auto piece = [&](std::size_t end, SyntaxKind kind) {
            while (drawn < end) {
                if (start + drawn >= code.endOfRow(row)) at = {layout.origin.x, layout.top(++row)};
                const std::string_view part =
                    words.substr(drawn, std::min(end, code.endOfRow(row) - start) - drawn);
                draw.AddText(at, syntaxColor(kind), part.data(), part.data() + part.size());
                at.x += widthOf(part);
                drawn += part.size();
            }
        };
        for (const SyntaxPiece& each : pieces) {
            if (each.begin > drawn) piece(each.begin, SyntaxKind::plain);
            piece(each.end, each.kind);
        }
        if (drawn < words.size()) piece(words.size(), SyntaxKind::plain);
    }
}

/// The numbers of the lines, beside their first rows.
void drawGutter(const CodeLayout& layout, const CodeText& code, const CodeView& view,
                std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    for (int row = layout.firstRow; row <= layout.lastRow; ++row) {
        const std::size_t start = code.rows[static_cast<std::size_t>(row - 1)];
        const int line = lineOf(code.lines, start);
        if (code.lines[static_cast<std::size_t>(line - 1)] != start) continue;
        const std::string number = std::to_string(line);
        const auto mark =
            std::ranges::find_if(marks, [&](const CodeMark& each) { return each.line == line; });
        const ImU32 color = mark != marks.end() ? packed(severityColor(mark->severity))
                            : line == view.line ? syntaxColor(SyntaxKind::plain)
                                                : packed(palette().dim);
        draw.AddText({window.x + layout.gutter - widthOf(number) - layout.lineHeight / 2, layout.top(row)},
                     color, number.c_str());
    }
}

void drawCursor(const CodeLayout& layout, const CodeText& code, const CodeView& view) {
    const int row = code.rowOfCursor(view);
    const auto start = code.rows[static_cast<std::size_t>(row - 1)];
    const auto cursor = std::min(static_cast<std::size_t>(view.cursor), code.text.size());
    const float x = layout.origin.x + widthOf(code.text.substr(start, cursor - start));
    const float top = layout.top(row);
    ImGui::GetWindowDrawList()->AddLine({x, top}, {x, top + layout.lineHeight},
                                        syntaxColor(SyntaxKind::plain), 1.5F);
}

}  // namespace

std::size_t CodeText::endOfRow(int row) const {
    const auto next = static_cast<std::size_t>(row);
    if (next >= rows.size()) return text.size();
    return rows[next] - (text[rows[next] - 1] == '\n' ? 1 : 0);
}

int CodeText::rowOfCursor(const CodeView& view) const {
    const auto cursor = std::min(static_cast<std::size_t>(view.cursor), text.size());
    const int row = lineOf(rows, cursor);
    const bool isContinued =
        row > 1 && rows[static_cast<std::size_t>(row - 1)] == cursor && text[cursor - 1] != '\n';
    return isContinued && view.isAtEndOfRow ? row - 1 : row;
}

LineStarts lineStarts(std::string_view text) {
    LineStarts starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

int lineOf(const LineStarts& starts, std::size_t byte) {
    return static_cast<int>(std::ranges::upper_bound(starts, byte) - starts.begin());
}

std::string_view lineBefore(std::string_view text, const LineStarts& starts, std::size_t byte) {
    const std::size_t start = starts[static_cast<std::size_t>(lineOf(starts, byte) - 1)];
    return text.substr(start, byte - start);
}

float widthOf(std::string_view text) {
    // ImGui::CalcTextSize() rounds up, which adds up over the words of a line.
    return ImGui::GetFont()
        ->CalcTextSizeA(ImGui::GetFontSize(), std::numeric_limits<float>::max(), 0, text.data(),
                        text.data() + text.size())
        .x;
}

float gutterOf(const LineStarts& lines) {
    constexpr std::size_t kLeastDigits = 3;
    return ImGui::CalcTextSize("0").x *
               static_cast<float>(std::max(kLeastDigits, std::to_string(lines.size()).size())) +
           ImGui::GetFontSize();
}

std::vector<std::size_t> breaksIn(std::string_view text, float width) {
    // Also where there is no scroll bar, so that one that appears breaks nothing else.
    const float room = width - ImGui::GetStyle().ScrollbarSize - gutterOf(lineStarts(text));
    const float digit = widthOf("0");
    return breaksOf(text, std::max(room, 8 * digit), digit, widthOf);
}

CodeText codeOf(std::string_view text, const std::vector<std::size_t>& breaks) {
    CodeText code{text, lineStarts(text), {}};
    std::ranges::merge(code.lines, breaks, std::back_inserter(code.rows));
    return code;
}

CodeLayout layoutOf(const CodeText& code, bool isWrapped) {
    const auto rows = static_cast<int>(code.rows.size());
    float longest = 0;
    for (int row = 1; row <= rows; ++row)
        longest = std::max(
            longest, static_cast<float>(code.endOfRow(row) - code.rows[static_cast<std::size_t>(row - 1)]));
    const ImVec2 visible = ImGui::GetContentRegionAvail();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    CodeLayout layout;
    layout.lineHeight = ImGui::GetFontSize();
    layout.gutter = gutterOf(code.lines);
    layout.origin = {corner.x + layout.gutter, corner.y};
    layout.size = {visible.x - layout.gutter,
                   std::max(visible.y, static_cast<float>(rows + 1) * layout.lineHeight)};
    if (!isWrapped) layout.size.x = std::max(layout.size.x, (longest + 4) * ImGui::CalcTextSize("0").x);
    layout.visibleHeight = visible.y;
    layout.fitting = static_cast<int>(visible.y / layout.lineHeight);
    layout.firstRow = std::clamp(static_cast<int>(ImGui::GetScrollY() / layout.lineHeight) + 1, 1, rows);
    layout.lastRow = std::min(layout.firstRow + layout.fitting + 1, rows);
    return layout;
}

void drawCode(const CodeLayout& layout, const CodeText& code, const CodeView& view, const CodeMarks& marks,
              CodeLanguage language) {
    if (view.isActive) drawBelowSelection(layout, code, view.selection);
    drawMarkedLines(layout, code, marks.lines);
    drawGutter(layout, code, view, marks.lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    draw.PushClipRect({window.x + layout.gutter - 2, window.y},
                      {window.x + ImGui::GetWindowWidth(), window.y + ImGui::GetWindowHeight()}, true);
    drawFound(layout, code, marks);
    drawText(layout, code, language);
    drawUnderlines(layout, code, marks.lines);
    if (view.isActive) drawCursor(layout, code, view);
    draw.PopClipRect();
}

}  // namespace glibra::view
