#include "view/window/panels/code_drawing.h"

#include <algorithm>
#include <string>
#include <utility>

#include "view/window/panels/syntax_colors.h"

namespace glibra::view {
namespace {

constexpr ImU32 kErrorLine = IM_COL32(220, 50, 40, 60);
constexpr ImU32 kWarningLine = IM_COL32(230, 170, 30, 40);
constexpr ImU32 kFound = IM_COL32(200, 160, 40, 80);
constexpr ImU32 kFoundShown = IM_COL32(240, 150, 20, 170);
constexpr ImU32 kErrorText = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kErrorPlate = IM_COL32(165, 35, 30, 235);
constexpr ImU32 kWarningPlate = IM_COL32(140, 100, 10, 235);

std::string_view lineText(std::string_view text, const LineStarts& starts, int line) {
    const auto index = static_cast<std::size_t>(line - 1);
    const std::size_t begin = starts[index];
    const std::size_t end = index + 1 < starts.size() ? starts[index + 1] - 1 : text.size();
    return text.substr(begin, end - begin);
}

void drawMarks(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
               std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    const float right = window.x + ImGui::GetWindowWidth();
    int lineWithText = 0;  // a line shows only its first message
    for (const CodeMark& each : marks) {
        if (each.line < layout.firstLine || each.line > layout.lastLine) continue;
        const bool isError = each.severity == Severity::error;
        const float top = layout.top(each.line);
        draw.AddRectFilled({window.x, top}, {right, top + layout.lineHeight},
                           isError ? kErrorLine : kWarningLine);
        if (std::exchange(lineWithText, each.line) == each.line) continue;
        // The beginning of the message is drawn after the line. The whole message is below the editor.
        const float left = layout.origin.x + widthOf(lineText(text, starts, each.line)) + layout.lineHeight;
        const float pad = layout.lineHeight / 4;
        draw.AddRectFilled({left - pad, top + 1},
                           {left + widthOf(each.text) + pad, top + layout.lineHeight - 1},
                           isError ? kErrorPlate : kWarningPlate, 3);
        draw.AddText({left, top}, kErrorText, each.text.c_str());
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
        draw.AddRectFilled({left, layout.top(line)}, {left + width, layout.top(line) + layout.lineHeight},
                           i == marks.shown ? kFoundShown : kFound, 2);
    }
}

void drawText(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
              CodeLanguage language) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    bool inComment = false;
    for (int line = 1; line <= layout.lastLine; ++line) {
        const std::string_view words = lineText(text, starts, line);
        const std::vector<SyntaxPiece> pieces = syntaxOf(words, language, inComment);
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
        const bool isMarked =
            std::any_of(marks.begin(), marks.end(), [&](const CodeMark& each) { return each.line == line; });
        const ImGuiCol color = isMarked || line == view.line ? ImGuiCol_Text : ImGuiCol_TextDisabled;
        draw.AddText({window.x + layout.gutter - widthOf(number) - layout.lineHeight / 2, layout.top(line)},
                     ImGui::GetColorU32(color), number.c_str());
    }
}

void drawCursor(const CodeLayout& layout, std::string_view text, const LineStarts& starts,
                const CodeView& view) {
    const auto start = starts[static_cast<std::size_t>(view.line - 1)];
    const auto cursor = std::min(static_cast<std::size_t>(view.cursor), text.size());
    const float x = layout.origin.x + widthOf(text.substr(start, cursor - start));
    const float top = layout.top(view.line);
    ImGui::GetWindowDrawList()->AddLine({x, top}, {x, top + layout.lineHeight},
                                        ImGui::GetColorU32(ImGuiCol_Text), 1.5F);
}

}  // namespace

LineStarts lineStarts(std::string_view text) {
    LineStarts starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

int lineOf(const LineStarts& starts, int byte) {
    const auto next = std::upper_bound(starts.begin(), starts.end(), static_cast<std::size_t>(byte));
    return static_cast<int>(next - starts.begin());
}

std::string_view lineBefore(std::string_view text, const LineStarts& starts, std::size_t byte) {
    const std::size_t start = starts[static_cast<std::size_t>(lineOf(starts, static_cast<int>(byte)) - 1)];
    return text.substr(start, byte - start);
}

float widthOf(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
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
    drawMarks(layout, text, starts, marks.lines);
    drawGutter(layout, view, marks.lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    draw.PushClipRect({window.x + layout.gutter - 2, window.y},
                      {window.x + ImGui::GetWindowWidth(), window.y + ImGui::GetWindowHeight()}, true);
    drawFound(layout, text, starts, marks);
    drawText(layout, text, starts, language);
    if (view.isActive) drawCursor(layout, text, starts, view);
    draw.PopClipRect();
}

}  // namespace glibra::view
