#include "view/window/panels/code_assist.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "editor/scene_check.h"
#include "glib/text.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

constexpr std::size_t kRows = 9;        ///< of the list
constexpr std::size_t kLeastTyped = 2;  ///< letters after which it opens by itself
constexpr double kHoverSeconds = .35;   ///< before the text about a name is shown

CodeContext contextOf(const Ui& ui, const EditedFile& file) {
    CodeContext context;
    context.language = glib::sameWord(file.path().extension().generic_string(), ".glib") ? CodeLanguage::glib
                                                                                         : CodeLanguage::glsl;
    for (const render::Knob& each : ui.values.knobs()) {
        std::string value;
        for (const double number : each.current)
            value += fmt::format("{}{:.6g}", value.empty() ? "" : " ", number);
        const std::string type = each.type.word.empty() ? "number" : each.type.word;
        const std::string what =
            each.program ? "a uniform of " + each.title : std::string("a variable of the scene");
        if (each.program) context.names.push_back({each.tag, type, what, value, CodeLanguage::glsl});
        context.names.push_back({each.tag, type, what, value, CodeLanguage::glib});
    }
    editor::addProgramNames(context, editor::namesOf(ui.session.live().scene()).programs, file.path(),
                            [&](const std::filesystem::path& path) {
                                const EditedFile* known = knownSource(ui, path);
                                return known ? known->text() : std::string();
                            });
    return context;
}

void updateWords(CodeAssist& state, const Ui& ui, const EditedFile& file, const CodeView& view) {
    const auto cursor = static_cast<std::size_t>(view.cursor);
    state.words = completionsAt(file.text(), cursor, contextOf(ui, file));
    state.typed = wordBefore(file.text(), cursor);
    if (!state.words.empty()) state.typed.begin = state.words.front().begin;
    state.cursor = view.cursor;
    state.chosen = 0;
    state.hasMoved = false;
    state.isOpen = !state.words.empty();
}

/// True if the typed word is one of the list, also in other case: `Dust` may be a new name beside `dust`.
bool isWholeWord(const CodeAssist& state, const EditedFile& file) {
    if (state.typed.end > file.text().size()) return false;
    const std::string typed = file.text().substr(state.typed.begin, state.typed.end - state.typed.begin);
    return std::ranges::any_of(state.words,
                               [&](const Completion& each) { return glib::sameWord(each.word, typed); });
}

void accept(CodeAssist& state, EditedFile& file, CodeView& view) {
    if (state.chosen >= state.words.size() || state.typed.end > file.text().size()) return;
    const std::string& word = state.words[state.chosen].word;
    file.history().endStep();
    view.newText = replaced(file.text(), {state.typed}, word);
    const std::size_t end = state.typed.begin + word.size();
    view.select = TextRange{end, end};
    state.isOpen = false;
    state.hasAccepted = true;
}

/// One row of the list. Returns true if it was clicked.
bool wordRow(Ui& ui, const CodeAssist& state, std::size_t index, float wordWidth, float width) {
    const Completion& each = state.words[index];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight();
    ImGui::PushID(static_cast<int>(index));
    const bool isClicked = ImGui::InvisibleButton("word", {width, height});
    ImGui::PopID();
    mark(ui, "completion/{}", index);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    if (index == state.chosen || ImGui::IsItemHovered())
        draw.AddRectFilled(at, {at.x + width, at.y + height}, tintColor(CodeTint::chosenRow));
    draw.AddText(at, syntaxColor(SyntaxKind::plain), each.word.c_str());
    draw.PushClipRect(at, {at.x + width, at.y + height}, true);
    draw.AddText({at.x + wordWidth, at.y}, packed(palette().dim), each.type.c_str());
    draw.PopClipRect();
    return isClicked;
}

/// Places the next window at the cursor, whole on the screen from left to right.
void placeAtCursor(const CodeView& view, float top, float width, float height) {
    const float most = std::max(0.F, ImGui::GetIO().DisplaySize.x - width);
    ImGui::SetNextWindowPos({std::clamp(view.cursorOnScreen.x, 0.F, most), top});
    ImGui::SetNextWindowSize({width, height});
}

void wordList(Ui& ui, CodeAssist& state, EditedFile& file, CodeView& view) {
    ImGui::PushFont(codeFont());
    const std::size_t rows = std::min(kRows, state.words.size());
    const std::size_t first =
        std::min(state.chosen < kRows ? 0 : state.chosen - kRows + 1, state.words.size() - rows);
    float wordWidth = 0;
    for (std::size_t i = first; i < first + rows; ++i)
        wordWidth = std::max(wordWidth, ImGui::CalcTextSize(state.words[i].word.c_str()).x);
    wordWidth += 16 * ui.shared.scale;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float line = ImGui::GetTextLineHeight();
    const float width = std::min(ImGui::GetIO().DisplaySize.x, 460 * ui.shared.scale);
    const float inside = width - 2 * style.WindowPadding.x;
    const std::string& what = state.words[state.chosen].what;
    const float whatHeight =
        what.empty() ? 0 : ImGui::CalcTextSize(what.c_str(), nullptr, false, inside).y + style.ItemSpacing.y;
    const float height = static_cast<float>(rows) * line + whatHeight + 2 * style.WindowPadding.y;
    // Below the cursor, or above it where there is more room.
    const CodeView::Corner& cursor = view.cursorOnScreen;
    const bool fitsBelow = cursor.bottom + height <= ImGui::GetIO().DisplaySize.y;
    placeAtCursor(view, fitsBelow ? cursor.bottom : std::max(0.F, cursor.top - height), width, height);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, packed(palette().popup));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, packed(palette().popup));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
        ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar;
    std::optional<std::size_t> clicked;
    if (ImGui::Begin("##completion", nullptr, kFlags)) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        for (std::size_t i = first; i < first + rows; ++i)
            if (wordRow(ui, state, i, wordWidth, inside)) clicked = i;
        ImGui::PopStyleVar();
        if (!what.empty()) wrappedText(palette().dim, what.c_str());
    }
    const bool isHovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    ImGui::PopFont();
    if (clicked) {
        state.chosen = *clicked;
        accept(state, file, view);
    } else if (!view.isActive && !isHovered && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        state.isOpen = false;
    }
}

/// The arguments of what is called, above the line of the cursor.
void argumentHint(Ui& ui, const CodeAssist& state, const CodeView& view) {
    ImGui::PushFont(codeFont());
    constexpr std::size_t kMost = 4;
    const std::size_t rows = std::min(kMost, state.hint.signatures.size());
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = 0;
    for (std::size_t i = 0; i < rows; ++i) {
        const SignatureParts& each = state.hint.signatures[i];
        width = std::max(width, ImGui::CalcTextSize((each.before + each.argument + each.after).c_str()).x);
    }
    width = std::min(ImGui::GetIO().DisplaySize.x, width + 2 * style.WindowPadding.x);
    const float height = static_cast<float>(rows) * ImGui::GetTextLineHeight() + 2 * style.WindowPadding.y;
    const float above = view.cursorOnScreen.top - height;
    // Below the line only where there is no room above it; the list of words stands below.
    placeAtCursor(view, above >= 0 ? above : view.cursorOnScreen.bottom, width, height);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, packed(palette().popup));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("##arguments", nullptr, kFlags)) {
        markWindow(ui, "arguments");
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
        for (std::size_t i = 0; i < rows; ++i) {
            const SignatureParts& each = state.hint.signatures[i];
            ImGui::TextUnformatted(each.before.c_str());
            if (each.argument.empty()) continue;
            ImGui::SameLine();
            ImGui::TextColored(asVector(palette().accent), "%s", each.argument.c_str());
            ImGui::SameLine();
            ImGui::TextUnformatted(each.after.c_str());
        }
        ImGui::PopStyleVar();
    }
    ImGui::End();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

/// Typing opens the arguments; they follow the cursor until nothing is called there.
void updateHint(CodeAssist& state, const Ui& ui, const EditedFile& file, const CodeView& view,
                bool isChanged) {
    if (isChanged) state.isHinting = true;
    if (!view.isActive) state.isHinting = false;
    if (!state.isHinting) {
        state.hint = {};
        return;
    }
    if (!isChanged && view.cursor == state.cursor) return;
    state.hint = callAt(file.text(), static_cast<std::size_t>(view.cursor), contextOf(ui, file));
    state.isHinting = !state.hint.word.empty();
}

/// The entry as text: code, value, sentences, chapter.
void entryText(const ReferenceEntry& entry) {
    ImGui::PushFont(codeFont());
    for (const std::string& each : entry.code) ImGui::TextWrapped("%s", each.c_str());
    if (!entry.value.empty()) ImGui::TextWrapped("now: %s", entry.value.c_str());
    ImGui::PopFont();
    if (!entry.text.empty()) ImGui::TextWrapped("%s", entry.text.c_str());
    if (!entry.chapter.empty()) ImGui::TextDisabled("%s", entry.chapter.c_str());
}

/// The messages of the line under the mouse, or what the name there is.
void hover(Ui& ui, CodeAssist& state, const EditedFile& file, const CodeView& view, bool isChanged) {
    if (state.isOpen || !view.hoveredLine || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    const std::size_t key = view.hovered ? wordAt(file.text(), *view.hovered).begin
                                         : static_cast<std::size_t>(*view.hoveredLine) | (1ULL << 40U);
    const double now = ImGui::GetTime();
    if (std::exchange(state.hovered, key) != key || isChanged) {
        state.hoveredSince = now;
        state.hoveredEntry =
            view.hovered ? referenceAt(file.text(), *view.hovered, contextOf(ui, file)) : ReferenceEntry();
    }
    std::string messages;
    Severity worst = Severity::warning;
    for (const Diagnostic& each : ui.session.diagnostics())
        if (each.severity != Severity::note && each.place.line == *view.hoveredLine &&
            each.place.file == file.path().generic_string()) {
            messages += (messages.empty() ? "" : "\n") + each.text;
            worst = std::max(worst, each.severity);
        }
    const ReferenceEntry& entry = state.hoveredEntry;
    if (messages.empty() && entry.word.empty()) return;
    if (now - state.hoveredSince < kHoverSeconds) {
        ui.frame.isFollowed = true;
        return;
    }
    ui.frame.hoverText = messages;
    for (const std::string& each : entry.code)
        ui.frame.hoverText += (ui.frame.hoverText.empty() ? "" : "\n") + each;
    if (!entry.value.empty()) ui.frame.hoverText += "\nnow: " + entry.value;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 32);
    if (!messages.empty()) wrappedText(severityColor(worst), messages.c_str());
    if (!entry.word.empty()) entryText(entry);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// What is known about the typed word: its entry, or the words that begin with it.
void lookUp(const Ui& ui, CodeAssist& state, const EditedFile* file) {
    CodeContext context;
    if (ui.session.hasScene() && file) context = contextOf(ui, *file);
    const std::string_view word = state.word.data();
    const CodeLanguage other = state.language == CodeLanguage::glib ? CodeLanguage::glsl : CodeLanguage::glib;
    state.entry = referenceOf(word, state.language, context);
    if (state.entry.word.empty())
        if (ReferenceEntry entry = referenceOf(word, other, context); !entry.word.empty())
            state.entry = std::move(entry);
    state.overview.clear();
    if (!state.entry.word.empty()) return;
    for (const CodeLanguage each : {state.language, other}) {
        context.language = each;
        for (Completion& one : completionsAt(word, word.size(), context))
            state.overview.push_back(std::move(one));
    }
}

/// The words to choose from. Returns the one that was clicked; empty if none was.
std::string overviewList(Ui& ui, const std::vector<Completion>& words) {
    std::string clicked;
    ImGui::BeginChild("overview");
    ImGui::PushFont(codeFont());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(words.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Completion& each = words[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            if (choice(ui, each.word.c_str(), false, "reference/word/{}", each.word)) clicked = each.word;
            ImGui::PopID();
            ImGui::SameLine(ImGui::GetFontSize() * 16);
            ImGui::TextDisabled("%s", each.type.c_str());
        }
    ImGui::PopFont();
    ImGui::EndChild();
    return clicked;
}

void take(const ShownText& active, EditedText edited) {
    active.file->history().endStep();
    active.view->newText = std::move(edited.text);
    active.view->select = edited.selection;
}

bool isWritable(const ShownText& active) {
    return active.file && active.file->whyReadOnly().empty();
}

}  // namespace

void assistKeys(CodeAssist& state, EditedFile& file, CodeView& view) {
    view.leavesListKeys = state.isOpen;
    // Undo, replacing and comments change the text without typing.
    state.hasAccepted = state.hasAccepted || view.newText;
    if (!state.isOpen || state.words.empty()) return;
    const std::size_t count = state.words.size();
    if (isKeyPressed(GLFW_KEY_DOWN)) state.chosen = (state.chosen + 1) % count;
    if (isKeyPressed(GLFW_KEY_UP)) state.chosen = (state.chosen + count - 1) % count;
    state.hasMoved = state.hasMoved || isKeyPressed(GLFW_KEY_DOWN) || isKeyPressed(GLFW_KEY_UP);
    if (isEnterPressed() && !state.hasMoved && isWholeWord(state, file)) {
        // Who has typed a whole word and goes on wants a new line.
        state.isOpen = view.leavesListKeys = false;
        return;
    }
    if (isKeyPressed(GLFW_KEY_TAB) || isEnterPressed()) accept(state, file, view);
}

void assist(Ui& ui, CodeAssist& state, EditedFile& file, CodeView& view, bool isChanged) {
    const bool mayEdit = file.whyReadOnly().empty();
    const bool hasAccepted = std::exchange(state.hasAccepted, false);
    if (std::exchange(state.isAsked, false) && mayEdit) {
        updateWords(state, ui, file, view);
    } else if (isChanged && view.isActive && !hasAccepted) {
        const TextRange typed = wordBefore(file.text(), static_cast<std::size_t>(view.cursor));
        const bool wasTyped = view.cursor > state.cursor || state.isOpen;
        const bool isLong = typed.end - typed.begin >= (state.isOpen ? 1 : kLeastTyped);
        if (isLong && wasTyped)
            updateWords(state, ui, file, view);
        else
            state.isOpen = false;
    } else if (view.cursor != state.cursor) {
        state.isOpen = false;
    }
    updateHint(state, ui, file, view, isChanged && mayEdit);
    state.cursor = view.cursor;
    if (state.isHinting) argumentHint(ui, state, view);
    if (state.isOpen && state.chosen < state.words.size()) wordList(ui, state, file, view);
    hover(ui, state, file, view, isChanged);
}

void referenceWindow(Ui& ui, CodeAssist& state, const EditedFile* file) {
    if (!state.showsReference) return;
    placeFloating(ui, 60, 60, 460, 260);
    if (ImGui::Begin("Reference", &state.showsReference, ImGuiWindowFlags_NoCollapse)) {
        ImGui::SetNextItemWidth(-1);
        if (std::exchange(state.focusEntry, false)) giveKeyboardToNext();
        if (ImGui::InputTextWithHint("##word", "a word of the scene language, of GLSL or of this scene",
                                     state.word.data(), state.word.size(), ImGuiInputTextFlags_AutoSelectAll))
            lookUp(ui, state, file);
        mark(ui, "reference/word");
        ImGui::Separator();
        entryText(state.entry);
        if (!state.overview.empty())
            if (const std::string word = overviewList(ui, state.overview); !word.empty()) {
                setField(state.word, word);
                lookUp(ui, state, file);
            }
    }
    ImGui::End();
}

void commentLines(const Ui& ui, const ShownText& active) {
    if (!isWritable(active)) return;
    const std::string& text = active.file->text();
    const TextRange& selection = active.view->selection;
    const LanguageAt at = languageAt(text, selection.begin, contextOf(ui, *active.file));
    take(active, toggledComments(text, selection, at.language == CodeLanguage::glsl ? "//" : "#"));
}

void indentLines(const CodeAssist& state, const ShownText& active, bool back) {
    if (!isWritable(active) || state.isOpen) return;  // Tab takes a word of the list
    take(active, indentedLines(active.file->text(), active.view->selection, back));
}

void showReference(const Ui& ui, CodeAssist& state, const ShownText& active, const EditedFile* file) {
    state.showsReference = true;
    state.isOpen = false;
    state.word[0] = 0;
    if (active.file) {
        const std::string& text = active.file->text();
        const CodeContext context = contextOf(ui, *active.file);
        const auto cursor = static_cast<std::size_t>(active.view->cursor);
        const TextRange range = nameNear(text, cursor);
        const std::string word = text.substr(range.begin, range.end - range.begin);
        state.language = languageAt(text, cursor, context).language;
        if (!word.empty()) {
            state.entry = referenceAt(text, range.begin, context);
            setField(state.word, word);
            state.overview.clear();
            if (!state.entry.word.empty()) return;
        }
    }
    // There is nothing to show an entry of: the user types a word or chooses one.
    state.focusEntry = state.word[0] == 0;
    lookUp(ui, state, file);
}

bool closeAssist(CodeAssist& state) {
    if (state.isOpen) {
        state.isOpen = false;
        return true;
    }
    if (std::exchange(state.isHinting, false)) return true;
    return std::exchange(state.showsReference, false);
}

}  // namespace glibra::view
