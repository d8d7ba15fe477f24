#include "view/window/panels/code_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "view/window/panels/code_colors.h"
#include "view/window/theme.h"

namespace glibra::view {
namespace {

constexpr ImU32 kErrorLine = IM_COL32(220, 50, 40, 60);
constexpr ImU32 kWarningLine = IM_COL32(230, 170, 30, 40);
/// Giving a widget the keyboard takes that many frames and scrolls to its corner, which is not wanted.
constexpr int kFramesOfFocus = 3;
constexpr ImU32 kFound = IM_COL32(200, 160, 40, 80);
constexpr ImU32 kFoundShown = IM_COL32(240, 150, 20, 170);
constexpr ImU32 kErrorText = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kErrorPlate = IM_COL32(165, 35, 30, 235);
constexpr ImU32 kWarningPlate = IM_COL32(140, 100, 10, 235);

/// Offsets of the first bytes of all lines.
std::vector<std::size_t> lineStarts(std::string_view text) {
    std::vector<std::size_t> starts{0};
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
        starts.push_back(at + 1);
    return starts;
}

int lineOf(const std::vector<std::size_t>& starts, int byte) {
    const auto next = std::upper_bound(starts.begin(), starts.end(), static_cast<std::size_t>(byte));
    return static_cast<int>(next - starts.begin());
}

std::string_view lineText(std::string_view text, const std::vector<std::size_t>& starts, int line) {
    const auto index = static_cast<std::size_t>(line - 1);
    const std::size_t begin = starts[index];
    const std::size_t end = index + 1 < starts.size() ? starts[index + 1] - 1 : text.size();
    return text.substr(begin, end - begin);
}

float widthOf(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

struct Editing {
    std::string& text;
    CodeView& view;
    int pageLines = 1;
};

/// What begins the line that the cursor has just left by Enter begins the new one too.
void indent(ImGuiInputTextCallbackData& data, const CodeView& view) {
    const bool isEnter = data.BufTextLen == view.previousSize + 1 && data.CursorPos == view.cursor + 1 &&
                         data.CursorPos > 0 && data.Buf[data.CursorPos - 1] == '\n';
    if (!isEnter) return;
    const std::string_view before(data.Buf, static_cast<std::size_t>(data.CursorPos - 1));
    const std::size_t end = before.rfind('\n');
    std::string_view line = end == std::string_view::npos ? before : before.substr(end + 1);
    line = line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string blanks(line);
    data.InsertChars(data.CursorPos, blanks.c_str());
}

/// Page up and down go by what is seen; the widget itself believes that all of its text is.
void turnPage(ImGuiInputTextCallbackData& data, const Editing& editing) {
    const bool up = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageUp));
    const bool down = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageDown));
    if (up == down) return;
    const std::string_view text(data.Buf, static_cast<std::size_t>(data.BufTextLen));
    const std::vector<std::size_t> starts = lineStarts(text);
    const int before = lineOf(starts, std::min(editing.view.cursor, data.BufTextLen));
    const int line = std::clamp(before + (up ? -editing.pageLines : editing.pageLines), 1,
                                static_cast<int>(starts.size()));
    data.CursorPos = static_cast<int>(starts[static_cast<std::size_t>(line - 1)]);
    data.SelectionStart = data.SelectionEnd = data.CursorPos;
}

int onEdit(ImGuiInputTextCallbackData* data) {
    Editing& editing = *static_cast<Editing*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        editing.text.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = editing.text.data();
        return 0;
    }
    CodeView& view = editing.view;
    if (const auto text = std::exchange(view.newText, std::nullopt)) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, text->data(), text->data() + text->size());
    }
    if (const auto range = std::exchange(view.select, std::nullopt)) {
        const auto inside = [&](std::size_t at) { return std::min(static_cast<int>(at), data->BufTextLen); };
        data->SelectionStart = inside(range->begin);
        data->CursorPos = data->SelectionEnd = inside(range->end);
    } else if (view.goTo) {
        const std::vector<std::size_t> starts =
            lineStarts({data->Buf, static_cast<std::size_t>(data->BufTextLen)});
        const int line = std::clamp(*view.goTo, 1, static_cast<int>(starts.size()));
        data->CursorPos = static_cast<int>(starts[static_cast<std::size_t>(line - 1)]);
        data->SelectionStart = data->SelectionEnd = data->CursorPos;
        view.goTo.reset();
    } else if (view.isActive) {
        indent(*data, view);
        turnPage(*data, editing);
    }
    view.cursor = data->CursorPos;
    view.previousSize = data->BufTextLen;
    const auto [first, last] = std::minmax(data->SelectionStart, data->SelectionEnd);
    view.selection = {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
    if (first == last) view.selection.begin = view.selection.end = static_cast<std::size_t>(view.cursor);
    return 0;
}

using Scroll = CodeView::Scroll;

/// Where things stand on the screen.
struct Layout {
    ImVec2 origin;  ///< of the first character
    float gutter = 0, lineHeight = 0;
    int firstLine = 1, lastLine = 1;  ///< that are seen
    [[nodiscard]] float top(int line) const { return origin.y + static_cast<float>(line - 1) * lineHeight; }
};

void drawMarks(const Layout& layout, std::string_view text, const std::vector<std::size_t>& starts,
               std::span<const CodeMark> marks) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    const float right = window.x + ImGui::GetWindowWidth();
    int said = 0;
    for (const CodeMark& each : marks) {
        if (each.line < layout.firstLine || each.line > layout.lastLine) continue;
        const bool isError = each.severity == Severity::error;
        const float top = layout.top(each.line);
        draw.AddRectFilled({window.x, top}, {right, top + layout.lineHeight},
                           isError ? kErrorLine : kWarningLine);
        if (std::exchange(said, each.line) == each.line) continue;
        // The beginning of the message behind the text; all of it stands below the editor.
        const float left = layout.origin.x + widthOf(lineText(text, starts, each.line)) + layout.lineHeight;
        const float pad = layout.lineHeight / 4;
        draw.AddRectFilled({left - pad, top + 1},
                           {left + widthOf(each.text) + pad, top + layout.lineHeight - 1},
                           isError ? kErrorPlate : kWarningPlate, 3);
        draw.AddText({left, top}, kErrorText, each.text.c_str());
    }
}

/// Places that a search has found, as far as they stand in one line.
void drawFound(const Layout& layout, std::string_view text, const std::vector<std::size_t>& starts,
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

void drawText(const Layout& layout, std::string_view text, const std::vector<std::size_t>& starts,
              Dialect dialect) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    bool inComment = false;
    for (int line = 1; line <= layout.lastLine; ++line) {
        const std::string_view words = lineText(text, starts, line);
        const std::vector<Painted> pieces = painted(words, dialect, inComment);
        if (line < layout.firstLine) continue;
        ImVec2 at(layout.origin.x, layout.top(line));
        std::size_t drawn = 0;
        const auto piece = [&](std::size_t end, Paint paint) {
            const std::string_view part = words.substr(drawn, end - drawn);
            draw.AddText(at, colorOf(paint), part.data(), part.data() + part.size());
            at.x += widthOf(part);
            drawn = end;
        };
        for (const Painted& each : pieces) {
            if (each.begin > drawn) piece(each.begin, Paint::plain);
            piece(each.end, each.paint);
        }
        if (drawn < words.size()) piece(words.size(), Paint::plain);
    }
}

void drawGutter(const Layout& layout, const CodeView& view, std::span<const CodeMark> marks) {
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

void drawCursor(const Layout& layout, std::string_view text, const std::vector<std::size_t>& starts,
                const CodeView& view) {
    const auto start = starts[static_cast<std::size_t>(view.line - 1)];
    const auto cursor = std::min(static_cast<std::size_t>(view.cursor), text.size());
    const float x = layout.origin.x + widthOf(text.substr(start, cursor - start));
    const float top = layout.top(view.line);
    ImGui::GetWindowDrawList()->AddLine({x, top}, {x, top + layout.lineHeight},
                                        ImGui::GetColorU32(ImGuiCol_Text), 1.5F);
}

/// Scrolled so far that the line, and from `x` on some characters, are seen.
Scroll revealed(Scroll scroll, const Layout& layout, int line, float x, bool inMiddle) {
    const float height = ImGui::GetWindowHeight() - ImGui::GetStyle().ScrollbarSize;
    const float width = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
    const float top = static_cast<float>(line - 1) * layout.lineHeight;
    const bool isAbove = top < scroll.y;
    if (isAbove || top + 2 * layout.lineHeight > scroll.y + height) {
        const bool isFar = top < scroll.y - height || top > scroll.y + 2 * height;
        scroll.y =
            inMiddle || isFar ? top - height / 2 : (isAbove ? top : top + 2 * layout.lineHeight - height);
    }
    // The beginning of the lines is seen too wherever that is possible.
    const float right = x + layout.gutter + 2 * layout.lineHeight;
    if (right <= width && (inMiddle || x < scroll.x))
        scroll.x = 0;
    else if (x < scroll.x)
        scroll.x = x - layout.lineHeight;
    else if (right > scroll.x + width)
        scroll.x = x + layout.gutter + 4 * layout.lineHeight - width;
    return {std::max(0.F, scroll.x), std::max(0.F, scroll.y)};
}

int charactersIn(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char each) {
        return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U;
    }));
}

/// The widget that edits: its text is there but not seen, since it has one colour only.
bool edit(const char* name, Editing editing, const ImVec2& size, bool isReadOnly) {
    ImGuiIO& io = ImGui::GetIO();
    const std::string label = fmt::format("##{}/{}", name, editing.view.generation);
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    // Esc would undo everything since the widget got the keyboard.
    const int escape = std::exchange(io.KeyMap[ImGuiKey_Escape], -1);
    const bool isChanged =
        ImGui::InputTextMultiline(label.c_str(), editing.text.data(), editing.text.capacity() + 1, size,
                                  ImGuiInputTextFlags_AllowTabInput | ImGuiInputTextFlags_CallbackResize |
                                      ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_NoUndoRedo |
                                      (isReadOnly ? ImGuiInputTextFlags_ReadOnly : 0),
                                  onEdit, &editing);
    io.KeyMap[ImGuiKey_Escape] = escape;
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    return isChanged;
}

}  // namespace

bool codeEditor(const char* name, std::string& text, CodeView& view, const CodeMarks& marks, Dialect dialect,
                bool isReadOnly, float below) {
    ImGui::PushFont(codeFont());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::BeginChild(name, {0, -below}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNavInputs);
    // While it has the keyboard the widget has a text of its own, which onEdit() changes.
    const bool isReplaced = view.newText && !view.isActive;
    if (isReplaced) text = *std::exchange(view.newText, std::nullopt);
    std::vector<std::size_t> starts = lineStarts(text);
    // Somebody else may have made it shorter.
    view.cursor = std::clamp(view.cursor, 0, static_cast<int>(text.size()));
    view.line = lineOf(starts, view.cursor);
    const float lineHeight = ImGui::GetFontSize();
    const float digit = ImGui::CalcTextSize("0").x;
    float longest = 0;
    for (int line = 1; line <= static_cast<int>(starts.size()); ++line)
        longest = std::max(longest, static_cast<float>(lineText(text, starts, line).size()));
    Layout layout;
    layout.lineHeight = lineHeight;
    layout.gutter =
        digit * static_cast<float>(std::max<std::size_t>(3, std::to_string(starts.size()).size())) +
        lineHeight;
    const ImVec2 seen = ImGui::GetContentRegionAvail();
    const ImVec2 size(std::max(seen.x - layout.gutter, (longest + 4) * digit),
                      std::max(seen.y, (static_cast<float>(starts.size()) + 1) * lineHeight));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    layout.origin = {corner.x + layout.gutter, corner.y};
    const int rows = static_cast<int>(seen.y / lineHeight);
    layout.firstLine = std::clamp(static_cast<int>(ImGui::GetScrollY() / lineHeight) + 1, 1,
                                  static_cast<int>(starts.size()));
    layout.lastLine = std::min(layout.firstLine + rows + 1, static_cast<int>(starts.size()));
    const bool goes = view.goTo || view.select;
    if (goes && !view.isActive) {
        ImGui::SetKeyboardFocusHere();
        view.framesToHold = kFramesOfFocus;
    }
    const int cursorBefore = view.cursor;
    // What is seen is drawn before the widget, under its selection.
    const std::string_view shown = text;
    drawMarks(layout, shown, starts, marks.lines);
    drawGutter(layout, view, marks.lines);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 window = ImGui::GetWindowPos();
    draw.PushClipRect({window.x + layout.gutter - 2, window.y},
                      {window.x + ImGui::GetWindowWidth(), window.y + ImGui::GetWindowHeight()}, true);
    drawFound(layout, shown, starts, marks);
    drawText(layout, shown, starts, dialect);
    if (view.isActive) drawCursor(layout, shown, starts, view);
    draw.PopClipRect();
    ImGui::SetCursorScreenPos(layout.origin);
    const bool isChanged = edit(name, {text, view, std::max(1, rows - 1)}, size, isReadOnly);
    view.isActive = ImGui::IsItemActive();

    if (isChanged) starts = lineStarts(text);
    view.cursor = std::clamp(view.cursor, 0, static_cast<int>(text.size()));
    view.line = lineOf(starts, view.cursor);
    const std::string_view before = std::string_view(text).substr(
        starts[static_cast<std::size_t>(view.line - 1)],
        static_cast<std::size_t>(view.cursor) - starts[static_cast<std::size_t>(view.line - 1)]);
    view.column = charactersIn(before) + 1;
    const bool isLower = std::exchange(view.height, seen.y) > seen.y;
    const bool holds = view.framesToHold > 0 && view.framesToHold-- > 0;
    const Scroll scrolled{ImGui::GetScrollX(), ImGui::GetScrollY()};
    Scroll scroll = holds ? view.scroll : scrolled;
    if (view.isActive && (view.cursor != cursorBefore || isChanged || goes || isLower))
        scroll = revealed(scroll, layout, view.line, widthOf(before), goes);
    if (const auto byte = std::exchange(view.reveal, std::nullopt)) {
        const auto at = std::min(*byte, text.size());
        const int line = lineOf(starts, static_cast<int>(at));
        const std::size_t start = starts[static_cast<std::size_t>(line - 1)];
        scroll =
            revealed(scroll, layout, line, widthOf(std::string_view(text).substr(start, at - start)), true);
    }
    if (scroll.x != scrolled.x) ImGui::SetScrollX(scroll.x);
    if (scroll.y != scrolled.y) ImGui::SetScrollY(scroll.y);
    view.scroll = scroll;
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return isChanged || isReplaced;
}

}  // namespace glibra::view
