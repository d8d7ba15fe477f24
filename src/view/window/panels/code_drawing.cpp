#include "view/window/panels/code_drawing.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/text.h"
#include "view/window/panels/syntax_colors.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

std::string_view lineText(std::string_view text, const LineStarts& starts, int line) {
    const auto index = static_cast<std::size_t>(line - 1);
    const std::size_t begin = starts[index];
    const std::size_t end = index + 1 < starts.size() ? starts[index + 1] - 1 : text.size();
    return text.substr(begin, end - begin);
}

/// Fills a rectangle with a tint. Over the picture the panel lets a part of it be seen; below a tint it does
/// not, so that the text stays readable.
void drawTint(const ImVec2& low, const ImVec2& high, CodeTint tint, float rounding = 0) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, high, packed(palette().panel), rounding);
    draw.AddRectFilled(low, high, tintColor(tint), rounding);
}

/// The panel below the lines with selected text, which the widget tints.
void drawBelowSelection(const CodeLayout& layout, const LineStarts& starts, const TextRange& selection) {
    if (selection.begin == selection.end) return;
    const int first = std::max(layout.firstLine, lineOf(starts, static_cast<int>(selection.begin)));
    const int last = std::min(layout.lastLine, lineOf(starts, static_cast<int>(selection.end)));
    if (first > last) return;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {layout.origin.x, layout.top(first)},
        {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(), layout.top(last) + layout.lineHeight},
        packed(palette().panel));
}

/// The word at the place that a message names, or one character.
TextRange markedPart(std::string_view line, int column) {
    const auto first = std::min(static_cast<std::size_t>(std::max(1, column)) - 1, line.size());
    const auto isOfWord = [&](std::size_t at) { return at < line.size() && base::isOfName(line[at]); };
    std::size_t end = first;
    while (isOfWord(end)) ++end;
    return {first, std::max(end, first + 1)};
}

/// A wave below the part of a line.
void underline(const CodeLayout& layout, std::string_view line, const TextRange& part, float top,
               ImU32 color) {
    const float digit = widthOf("0");
    const float left = layout.origin.x + widthOf(line.substr(0, part.begin));
    const std::string_view marked = line.substr(part.begin, part.end - part.begin);
    const float right = left + std::max(digit, widthOf(marked));
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

/// Tints the lines with messages, and marks them at the left edge. The messages themselves are in the list
/// below the text.
void drawMarkedLines(const CodeLayout& layout, std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    int lineBefore = 0;
    for (const CodeMark& each : marks) {
        if (each.line < layout.firstLine || each.line > layout.lastLine) continue;
        // The marks of a line follow each other, the worst one first.
        if (std::exchange(lineBefore, each.line) == each.line) continue;
        const bool isError = each.severity == Severity::error;
        const float top = layout.top(each.line);
        drawTint({window.x, top}, {window.x + ImGui::GetWindowWidth(), top + layout.lineHeight},
                 isError ? CodeTint::errorLine : CodeTint::warningLine);
        draw.AddRectFilled({window.x, top}, {window.x + layout.lineHeight / 3, top + layout.lineHeight},
                           packed(severityColor(each.severity)));
    }
}

void drawUnderlines(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
                    std::span<const CodeMark> marks) {
    for (const CodeMark& each : marks) {
        if (each.line < layout.firstLine || each.line > layout.lastLine) continue;
        const std::string_view line = lineText(text, starts, each.line);
        underline(layout, line, markedPart(line, each.column), layout.top(each.line),
                  packed(severityColor(each.severity)));
    }
}

/// The matches of a search; a match over several lines is marked in its first line.
void drawFound(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
               const CodeMarks& marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < marks.found.size(); ++i) {
        const TextRange& each = marks.found[i];
        if (each.end > text.size()) break;
        const int line = lineOf(starts, static_cast<int>(each.begin));
        if (line < layout.firstLine || line > layout.lastLine) continue;
        const std::size_t start = starts[static_cast<std::size_t>(line - 1)];
        const float left = layout.origin.x + widthOf(text.substr(start, each.begin - start));
        const float width = widthOf(text.substr(each.begin, each.end - each.begin));
        drawTint({left, layout.top(line)}, {left + width, layout.top(line) + layout.lineHeight},
                 i == marks.shown ? CodeTint::foundShown : CodeTint::found, 2);
        if (i == marks.shown)
            draw.AddRect({left - 1, layout.top(line)},
                         {left + width + 1, layout.top(line) + layout.lineHeight}, packed(palette().warning),
                         2);
    }
}

void drawText(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
              CodeLanguage language) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    SyntaxReader syntax(language);
    for (int line = 1; line <= layout.lastLine; ++line) {
        const std::string_view words = lineText(text, starts, line);
        const std::vector<SyntaxPiece> pieces = syntax.next(words);
        if (line < layout.firstLine) continue;
        ImVec2 at(layout.origin.x, layout.top(line));
        std::size_t drawn = 0;
        const auto piece = [&](std::size_t end, SyntaxKind kind) {
            const std::string_view part = words.substr(drawn, end - drawn);
            draw.AddText(at, syntaxColor(kind), part.data(), part.data() + part.size());
            at.x += widthOf(part);
            drawn = end;
        };
        for (const SyntaxPiece& each : pieces) {
            if (each.begin > drawn) piece(each.begin, SyntaxKind::plain);
            piece(each.end, each.kind);
        }
        if (drawn < words.size()) piece(words.size(), SyntaxKind::plain);
    }
}

void drawGutter(const CodeLayout& layout, const CodeView& view, std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    for (int line = layout.firstLine; line <= layout.lastLine; ++line) {
        const std::string number = std::to_string(line);
        const auto mark =
            std::ranges::find_if(marks, [&](const CodeMark& each) { return each.line == line; });
        const ImU32 color = mark != marks.end() ? packed(severityColor(mark->severity))
                            : line == view.line ? syntaxColor(SyntaxKind::plain)
                                                : packed(palette().dim);
        draw.AddText({window.x + layout.gutter - widthOf(number) - layout.lineHeight / 2, layout.top(line)},
                     color, number.c_str());
    }
}

void drawCursor(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
                const CodeView& view) {
    const auto start = starts[static_cast<std::size_t>(view.line - 1)];
    const auto cursor = std::min(static_cast<std::size_t>(view.cursor), text.size());
    const float x = layout.origin.x + widthOf(text.substr(start, cursor - start));
    const float top = layout.top(view.line);
    ImGui::GetWindowDrawList()->AddLine({x, top}, {x, top + layout.lineHeight},
                                        syntaxColor(SyntaxKind::plain), 1.5F);
}

}  // namespace

LineStarts lineStarts(std::string_view text) {
    LineStarts starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

int lineOf(const LineStarts& starts, int byte) {
    const auto next = std::ranges::upper_bound(starts, static_cast<std::size_t>(byte));
    return static_cast<int>(next - starts.begin());
}

std::string_view lineBefore(std::string_view text, const LineStarts& starts, std::size_t byte) {
    const std::size_t start = starts[static_cast<std::size_t>(lineOf(starts, static_cast<int>(byte)) - 1)];
    return text.substr(start, byte - start);
}

float widthOf(std::string_view text) {
    // ImGui::CalcTextSize() rounds up, which adds up over the words of a line.
    return ImGui::GetFont()
        ->CalcTextSizeA(ImGui::GetFontSize(), std::numeric_limits<float>::max(), 0, text.data(),
                        text.data() + text.size())
        .x;
}

CodeLayout layoutOf(std::string_view text, const LineStarts& starts) {
    constexpr std::size_t kLeastDigits = 3;
    const auto lines = static_cast<int>(starts.size());
    const float digit = ImGui::CalcTextSize("0").x;
    float longest = 0;
    for (int line = 1; line <= lines; ++line)
        longest = std::max(longest, static_cast<float>(lineText(text, starts, line).size()));
    const ImVec2 visible = ImGui::GetContentRegionAvail();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    CodeLayout layout;
    layout.lineHeight = ImGui::GetFontSize();
    layout.gutter =
        digit * static_cast<float>(std::max(kLeastDigits, std::to_string(lines).size())) + layout.lineHeight;
    layout.origin = {corner.x + layout.gutter, corner.y};
    layout.size = {std::max(visible.x - layout.gutter, (longest + 4) * digit),
                   std::max(visible.y, static_cast<float>(lines + 1) * layout.lineHeight)};
    layout.visibleHeight = visible.y;
    layout.rows = static_cast<int>(visible.y / layout.lineHeight);
    layout.firstLine = std::clamp(static_cast<int>(ImGui::GetScrollY() / layout.lineHeight) + 1, 1, lines);
    layout.lastLine = std::min(layout.firstLine + layout.rows + 1, lines);
    return layout;
}

void drawCode(const CodeLayout& layout, std::string_view text, const LineStarts& starts, const CodeView& view,
              const CodeMarks& marks, CodeLanguage language) {
    if (view.isActive) drawBelowSelection(layout, starts, view.selection);
    drawMarkedLines(layout, marks.lines);
    drawGutter(layout, view, marks.lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    draw.PushClipRect({window.x + layout.gutter - 2, window.y},
                      {window.x + ImGui::GetWindowWidth(), window.y + ImGui::GetWindowHeight()}, true);
    drawFound(layout, text, starts, marks);
    drawText(layout, text, starts, language);
    drawUnderlines(layout, text, starts, marks.lines);
    if (view.isActive) drawCursor(layout, text, starts, view);
    draw.PopClipRect();
}

}  // namespace glibra::view
