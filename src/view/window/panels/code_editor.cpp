#include "view/window/panels/code_editor.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// Moving the keyboard focus to a widget takes this many frames and scrolls to its corner, which is not
/// wanted.
constexpr int kFramesOfFocus = 3;

struct Editing {
    std::string& text;
    CodeView& view;
    bool isReadOnly = false;
    int pageRows = 1;
    float width = 0;  ///< of the window, pixels
    [[nodiscard]] std::string& buffer() const { return view.isWrapped ? view.buffer : text; }
};

/// After Enter, indents the new line like the one before, and by four more after an opening brace.
void indent(ImGuiInputTextCallbackData& data, const CodeView& view) {
    const bool isEnter = data.BufTextLen == view.previousSize + 1 && data.CursorPos == view.cursor + 1 &&
                         data.CursorPos > 0 && data.Buf[data.CursorPos - 1] == '\n';
    if (!isEnter) return;
    const std::string_view before(data.Buf, static_cast<std::size_t>(data.CursorPos - 1));
    const std::size_t end = before.rfind('\n');
    std::string_view line = end == std::string_view::npos ? before : before.substr(end + 1);
    const std::size_t last = line.find_last_not_of(" \t");
    const bool isOpening = last != std::string_view::npos && line[last] == '{';
    if (last == std::string_view::npos && !line.empty()) {
        // The blanks of a line that stays empty move on to the next one.
        const std::string moved(line);
        data.DeleteChars(data.CursorPos - 1 - static_cast<int>(moved.size()), static_cast<int>(moved.size()));
        data.InsertChars(data.CursorPos, moved.c_str());
        return;
    }
    line = line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string blanks = std::string(line) + (isOpening ? "    " : "");
    data.InsertChars(data.CursorPos, blanks.c_str());
}

/// Ctrl+Delete takes the rest of the word, of which Dear ImGui 1.86 takes one letter only. `before`: the text
/// as it was.
void deleteWord(ImGuiInputTextCallbackData& data, std::string_view before, const CodeView& view) {
    if (!ImGui::GetIO().KeyCtrl || !isKeyPressed(GLFW_KEY_DELETE)) return;
    const auto at = static_cast<std::size_t>(data.CursorPos);
    const std::size_t removed = before.size() - static_cast<std::size_t>(data.BufTextLen);
    if (data.CursorPos != view.cursor || data.BufTextLen >= static_cast<int>(before.size()) ||
        view.selection.begin != view.selection.end)
        return;
    const std::size_t wanted = endOfWord(before, at) - at;
    if (wanted > removed) data.DeleteChars(data.CursorPos, static_cast<int>(wanted - removed));
}

/// A closing brace that is typed as the first character of a line takes four blanks back.
void unindent(ImGuiInputTextCallbackData& data, const CodeView& view) {
    const bool isTyped = data.BufTextLen == view.previousSize + 1 && data.CursorPos == view.cursor + 1 &&
                         data.CursorPos > 4 && data.Buf[data.CursorPos - 1] == '}';
    if (!isTyped) return;
    const std::string_view before(data.Buf, static_cast<std::size_t>(data.CursorPos - 1));
    const std::string_view line = before.substr(before.rfind('\n') + 1);
    const bool isBlank = line.find_first_not_of(' ') == std::string_view::npos;
    if (isBlank && line.size() >= 4) data.DeleteChars(data.CursorPos - 5, 4);
}

/// Moves by the visible rows on Page Up and Page Down. ImGui would take the whole text as visible.
void turnPage(ImGuiInputTextCallbackData& data, const Editing& editing) {
    const bool up = isKeyPressed(GLFW_KEY_PAGE_UP);
    const bool down = isKeyPressed(GLFW_KEY_PAGE_DOWN);
    if (up == down) return;
    const LineStarts starts = lineStarts({data.Buf, static_cast<std::size_t>(data.BufTextLen)});
    const auto cursor = static_cast<std::size_t>(std::min(editing.view.cursorInRows, data.BufTextLen));
    const int line = std::clamp(lineOf(starts, cursor) + (up ? -editing.pageRows : editing.pageRows), 1,
                                static_cast<int>(starts.size()));
    data.CursorPos = static_cast<int>(starts[static_cast<std::size_t>(line - 1)]);
    data.SelectionStart = data.SelectionEnd = data.CursorPos;
}

/// What was asked for, and what belongs to a key, in the text without the breaks of rows.
void onText(ImGuiInputTextCallbackData& data, const Editing& editing) {
    CodeView& view = editing.view;
    if (view.isActive && !view.newText && !view.select) deleteWord(data, editing.text, view);
    if (const auto text = std::exchange(view.newText, std::nullopt)) {
        data.DeleteChars(0, data.BufTextLen);
        data.InsertChars(0, text->data(), text->data() + text->size());
    }
    if (const auto range = std::exchange(view.select, std::nullopt)) {
        const auto inside = [&](std::size_t at) { return std::min(static_cast<int>(at), data.BufTextLen); };
        data.SelectionStart = inside(range->begin);
        data.CursorPos = data.SelectionEnd = inside(range->end);
    } else if (view.goTo) {
        const LineStarts starts = lineStarts({data.Buf, static_cast<std::size_t>(data.BufTextLen)});
        const int line = std::clamp(*view.goTo, 1, static_cast<int>(starts.size()));
        data.CursorPos = static_cast<int>(starts[static_cast<std::size_t>(line - 1)]);
        data.SelectionStart = data.SelectionEnd = data.CursorPos;
        view.goTo.reset();
    } else if (view.isActive) {
        indent(data, view);
        unindent(data, view);
    }
    view.cursor = data.CursorPos;
    view.previousSize = data.BufTextLen;
    const auto [first, last] = std::minmax(data.SelectionStart, data.SelectionEnd);
    view.selection = {static_cast<std::size_t>(first), static_cast<std::size_t>(last)};
    if (first == last) view.selection.begin = view.selection.end = static_cast<std::size_t>(view.cursor);
}

/// Left and Right, if they have moved the cursor over the break of a row alone, move it once more.
void passBreak(ImGuiInputTextCallbackData& data, const CodeView& view) {
    const int step = data.CursorPos - view.cursorInRows;
    const auto inText = [&](int at) { return view.wrapped.placeInText(static_cast<std::size_t>(at)); };
    const bool isAlone = (step == 1 || step == -1) && inText(data.CursorPos) == inText(view.cursorInRows);
    const int next = data.CursorPos + step;
    if (!isAlone || next < 0 || next > data.BufTextLen) return;
    if (!isKeyPressed(step < 0 ? GLFW_KEY_LEFT : GLFW_KEY_RIGHT)) return;
    if (data.SelectionEnd == data.CursorPos) data.SelectionEnd = next;
    if (data.SelectionStart == data.CursorPos) data.SelectionStart = next;
    data.CursorPos = next;
}

/// The widget has edited rows: makes the text of them, and other rows if their breaks are others now.
void onRows(ImGuiInputTextCallbackData& data, const Editing& editing) {
    CodeView& view = editing.view;
    // Of a text that is only read, ImGui 1.86 gives the length alone.
    const std::string_view now = editing.isReadOnly
                                     ? std::string_view(view.wrapped.rows)
                                     : std::string_view(data.Buf, static_cast<std::size_t>(data.BufTextLen));
    if (now == view.wrapped.rows) passBreak(data, view);
    const EditedRows edited(view.wrapped, now, static_cast<std::size_t>(view.cursorInRows),
                            static_cast<std::size_t>(data.CursorPos),
                            view.selection.begin != view.selection.end);
    const auto inText = [&](int at) {
        return static_cast<int>(edited.placeInText(std::min(static_cast<std::size_t>(at), now.size())));
    };
    constexpr std::size_t kRoom = 1024;  // for what onText() inserts besides
    std::string text = edited.text();
    ImGuiInputTextCallbackData plain;
    plain.BufTextLen = static_cast<int>(text.size());
    text.resize(2 * text.size() + (view.newText ? view.newText->size() : 0) + kRoom);
    plain.Buf = text.data();
    plain.BufSize = static_cast<int>(text.size());
    plain.CursorPos = inText(data.CursorPos);
    plain.SelectionStart = inText(data.SelectionStart);
    plain.SelectionEnd = inText(data.SelectionEnd);
    const std::array before{plain.CursorPos, plain.SelectionStart, plain.SelectionEnd};
    onText(plain, editing);
    text.resize(static_cast<std::size_t>(plain.BufTextLen));
    WrappedText wrapped(text, breaksIn(text, editing.width));
    const bool isOther = now != wrapped.rows;
    if (isOther && !editing.isReadOnly) {
        data.DeleteChars(0, data.BufTextLen);
        data.InsertChars(0, wrapped.rows.data(), wrapped.rows.data() + wrapped.rows.size());
    }
    const std::array after{plain.CursorPos, plain.SelectionStart, plain.SelectionEnd};
    view.wrapped = std::move(wrapped);
    if (isOther || after != before) {
        const auto inRows = [&](int at) {
            return static_cast<int>(view.wrapped.placeInRows(static_cast<std::size_t>(at)));
        };
        data.CursorPos = inRows(plain.CursorPos);
        data.SelectionStart = inRows(plain.SelectionStart);
        data.SelectionEnd = inRows(plain.SelectionEnd);
    }
    const auto cursor = static_cast<std::size_t>(view.cursor);
    view.isAtEndOfRow = static_cast<std::size_t>(data.CursorPos) != view.wrapped.placeInRows(cursor);
    if (!editing.isReadOnly) editing.text = view.wrapped.text;
}

int onEdit(ImGuiInputTextCallbackData* data) {
    const Editing& editing = *static_cast<Editing*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        editing.buffer().resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = editing.buffer().data();
        return 0;
    }
    CodeView& view = editing.view;
    const bool turns = view.isActive && !view.newText && !view.select && !view.goTo;
    if (turns) turnPage(*data, editing);
    if (view.isWrapped)
        onRows(*data, editing);
    else
        onText(*data, editing);
    view.cursorInRows = data->CursorPos;
    return 0;
}

using Scroll = CodeView::Scroll;

/// The scroll position at which the row is visible, and some characters from `x` on.
Scroll revealed(Scroll scroll, const CodeLayout& layout, int row, float x, bool inMiddle) {
    const float height = ImGui::GetWindowHeight() - ImGui::GetStyle().ScrollbarSize;
    const float width = ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize;
    const float top = static_cast<float>(row - 1) * layout.lineHeight;
    const bool isAbove = top < scroll.y;
    if (isAbove || top + 2 * layout.lineHeight > scroll.y + height) {
        const bool isFar = top < scroll.y - height || top > scroll.y + 2 * height;
        scroll.y =
            inMiddle || isFar ? top - height / 2 : (isAbove ? top : top + 2 * layout.lineHeight - height);
    }
    // Keep the beginning of the lines visible where possible.
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
    return static_cast<int>(std::ranges::count_if(
        text, [](char each) { return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U; }));
}

/// The ImGui widget that edits. Its text is transparent, since it has only one colour; drawCode() draws it.
bool edit(const char* name, Editing editing, const ImVec2& size) {
    const std::string label = fmt::format("##{}/{}", name, editing.view.generation);
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleColor(ImGuiCol_TextSelectedBg, tintColor(CodeTint::selection));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
    // In ImGui, Esc undoes all edits since the widget got the keyboard focus.
    constexpr std::array kListKeys{GLFW_KEY_ESCAPE,   GLFW_KEY_TAB, GLFW_KEY_ENTER,
                                   GLFW_KEY_KP_ENTER, GLFW_KEY_UP,  GLFW_KEY_DOWN};
    const std::span<const int> listKeys = kListKeys;
    const HiddenKeys hidden(editing.view.leavesListKeys ? listKeys : listKeys.first(1));
    std::string& buffer = editing.buffer();
    const bool isChanged = ImGui::InputTextMultiline(
        label.c_str(), buffer.data(), buffer.capacity() + 1, size,
        ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackAlways |
            ImGuiInputTextFlags_NoUndoRedo | (editing.isReadOnly ? ImGuiInputTextFlags_ReadOnly : 0),
        onEdit, &editing);
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(3);
    return isChanged;
}

/// Finds the byte and line under the mouse, and where the cursor is on the screen.
void findPointer(CodeView& view, const CodeLayout& layout, const CodeText& code) {
    view.hovered.reset();
    view.hoveredLine.reset();
    const std::string_view text = code.text;
    const int rowOfCursor = code.rowOfCursor(view);
    const std::size_t start = code.rows[static_cast<std::size_t>(rowOfCursor - 1)];
    const float top = layout.top(rowOfCursor);
    const float x =
        layout.origin.x + widthOf(text.substr(start, static_cast<std::size_t>(view.cursor) - start));
    view.cursorOnScreen = {x, top, top + layout.lineHeight};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem |
                                ImGuiHoveredFlags_ChildWindows))
        return;
    const int row = static_cast<int>(std::floor((mouse.y - layout.origin.y) / layout.lineHeight)) + 1;
    if (row < 1 || row > static_cast<int>(code.rows.size())) return;
    const std::size_t begin = code.rows[static_cast<std::size_t>(row - 1)];
    view.hoveredLine = lineOf(code.lines, begin);
    const std::size_t end = code.endOfRow(row);
    if (mouse.x < layout.origin.x || mouse.x < ImGui::GetWindowPos().x + layout.gutter) return;
    for (std::size_t at = begin; at < end; ++at) {
        const bool isWhole = at + 1 == end || (static_cast<unsigned char>(text[at + 1]) & 0xC0U) != 0x80U;
        if (!isWhole || mouse.x >= layout.origin.x + widthOf(text.substr(begin, at + 1 - begin))) continue;
        view.hovered = at;
        return;
    }
}

/// Clamps the cursor to the text, which other code may have made shorter, and finds its line and column.
void updateCursor(CodeView& view, const CodeText& code) {
    view.cursor = std::clamp(view.cursor, 0, static_cast<int>(code.text.size()));
    const auto cursor = static_cast<std::size_t>(view.cursor);
    view.line = lineOf(code.lines, cursor);
    view.column = charactersIn(lineBefore(code.text, code.lines, cursor)) + 1;
}

/// Scrolls to the cursor if `followsCursor`, and to the byte that somebody has asked for.
void scroll(CodeView& view, const CodeLayout& layout, const CodeText& code, bool followsCursor,
            bool inMiddle) {
    const bool holds = view.framesToHold > 0 && view.framesToHold-- > 0;
    const Scroll before{ImGui::GetScrollX(), ImGui::GetScrollY()};
    Scroll now = holds ? view.scroll : before;
    const auto reveal = [&](std::size_t byte, int row, bool isCentred) {
        const std::size_t start = code.rows[static_cast<std::size_t>(row - 1)];
        now = revealed(now, layout, row, widthOf(code.text.substr(start, byte - start)), isCentred);
    };
    if (followsCursor) reveal(static_cast<std::size_t>(view.cursor), code.rowOfCursor(view), inMiddle);
    if (auto byte = std::exchange(view.reveal, std::nullopt)) {
        byte = std::min(*byte, code.text.size());
        reveal(*byte, lineOf(code.rows, *byte), true);
    }
    if (view.isWrapped) now.x = 0;
    if (now.x != before.x) ImGui::SetScrollX(now.x);
    if (now.y != before.y) ImGui::SetScrollY(now.y);
    view.scroll = now;
}

CodeText codeIn(const CodeView& view, std::string_view text) {
    return codeOf(text,
                  view.isWrapped ? breaksIn(text, ImGui::GetWindowWidth()) : std::vector<std::size_t>());
}

/// What ImGui copies has the line feeds of the breaks in it.
void copyWithoutBreaks(const CodeView& view, std::string_view text, const TextRange& selection) {
    const bool copies = ImGui::GetIO().KeyCtrl && (isKeyPressed(GLFW_KEY_C) || isKeyPressed(GLFW_KEY_X) ||
                                                   isKeyPressed(GLFW_KEY_INSERT));
    const bool cuts = ImGui::GetIO().KeyShift && isKeyPressed(GLFW_KEY_DELETE);
    if (!view.isWrapped || !view.isActive || selection.begin == selection.end || (!copies && !cuts)) return;
    ImGui::SetClipboardText(
        std::string(text.substr(selection.begin, selection.end - selection.begin)).c_str());
}

/// The widget in its child window. Returns true if the text has changed.
bool editInChild(const char* name, std::string& text, CodeView& view, const CodeMarks& marks,
                 CodeLanguage language, bool isReadOnly) {
    // While the widget has the keyboard focus it holds a copy of the text, which onEdit() changes.
    const bool isReplaced = view.newText && !view.isActive;
    if (isReplaced) text = *std::exchange(view.newText, std::nullopt);
    CodeText code = codeIn(view, text);
    updateCursor(view, code);
    const CodeLayout layout = layoutOf(code, view.isWrapped);
    const bool goes = view.goTo || view.select;
    if (goes && !view.isActive) {
        giveKeyboardToNext();
        view.framesToHold = kFramesOfFocus;
    }
    const int cursorBefore = view.cursor;
    const TextRange selectionBefore = view.selection;
    const std::string before = view.isWrapped ? text : std::string();
    if (view.isWrapped && (!view.isActive || isReadOnly)) {
        view.wrapped = WrappedText(text, breaksIn(text, ImGui::GetWindowWidth()));
        view.buffer = view.wrapped.rows;
    }
    // The text is drawn before the widget, below its selection.
    drawCode(layout, code, view, marks, language);
    ImGui::SetCursorScreenPos(layout.origin);
    const Editing editing{text, view, isReadOnly, std::max(1, layout.fitting - 1), ImGui::GetWindowWidth()};
    bool isChanged = edit(name, editing, layout.size);
    copyWithoutBreaks(view, before, selectionBefore);
    view.isActive = ImGui::IsItemActive();
    if (view.isWrapped) {
        // What it took in the frame in which it lost the keyboard.
        if (!isReadOnly && view.buffer != view.wrapped.rows)
            text = EditedRows(view.wrapped, view.buffer, static_cast<std::size_t>(view.cursorInRows),
                              view.buffer.size(), selectionBefore.begin != selectionBefore.end)
                       .text();
        isChanged = text != before;
    }

    if (isChanged) code = codeIn(view, text);
    updateCursor(view, code);
    const bool isLower = std::exchange(view.height, layout.visibleHeight) > layout.visibleHeight;
    // A longer line can be scrolled to its end only when the frames after it have made room.
    if (isChanged) view.framesToFollow = kFramesOfFocus;
    const bool isMade = view.framesToFollow > 0 && view.framesToFollow-- > 0;
    const bool followsCursor = view.isActive && (view.cursor != cursorBefore || isMade || goes || isLower);
    scroll(view, layout, code, followsCursor, goes);
    findPointer(view, layout, code);
    return isChanged || isReplaced;
}

}  // namespace

bool codeEditor(const char* name, std::string& text, CodeView& view, const CodeMarks& marks,
                CodeLanguage language, bool isReadOnly, float below, bool wraps) {
    if (std::exchange(view.isWrapped, wraps) != wraps) {
        // Another widget, since what it holds is another text; it takes the keyboard over.
        ++view.generation;
        if (std::exchange(view.isActive, false) && !view.select) view.select = view.selection;
    }
    ImGui::PushFont(codeFont());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // The window has the colour of the panel, or lets the picture be seen.
    ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32_BLACK_TRANS);
    ImGui::BeginChild(name, {0, -below}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNavInputs);
    const bool isChanged = editInChild(name, text, view, marks, language, isReadOnly);
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return isChanged;
}

}  // namespace glibra::view
