#include "view/window/panels/source_header.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/text.h"
#include "system/folder.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

bool fileHasError(const Ui& ui, const std::filesystem::path& file) {
    return std::ranges::any_of(ui.session.diagnostics(), [&](const Diagnostic& each) {
        return each.severity == Severity::error && isSame(each.place.file, file);
    });
}

/// A menu of where the source stands.
void placeMenu(Ui& ui) {
    constexpr const char* kLabel = "Place";
    continueRowForButton(kLabel);
    if (ImGui::Button(kLabel)) ImGui::OpenPopup("place");
    mark(ui, "source/place");
    tooltip("Beside, below or over the picture (Ctrl+Shift+E)");
    if (!ImGui::BeginPopup("place")) return;
    for (const SourcePlace each :
         {SourcePlace::automatic, SourcePlace::beside, SourcePlace::below, SourcePlace::over}) {
        if (ImGui::MenuItem(nameOfPlace(each), nullptr, each == ui.settings.sourcePlace))
            ui.settings.sourcePlace = each;
        mark(ui, "source/place/{}", nameOfPlace(each));
    }
    ImGui::Separator();
    if (ImGui::MenuItem("wrap long lines", nullptr, ui.settings.wrapsLines))
        ui.settings.wrapsLines = !ui.settings.wrapsLines;
    mark(ui, "source/wrap");
    ImGui::EndPopup();
}

/// Scrolls to the current match; selects it if the text has the keyboard focus.
void showMatch(FindBar& bar, CodeView& view) {
    if (bar.shown >= bar.found.size()) return;
    const TextRange& range = bar.found[bar.shown];
    bar.from = range.begin;
    if (view.isActive)
        view.select = range;
    else
        view.reveal = range.begin;
}

void stepToMatch(FindBar& bar, CodeView& view, bool backwards) {
    if (bar.found.empty()) return;
    // With the focus in the text the search starts at the cursor, otherwise at the current match.
    const bool isSelected = view.selection.begin != view.selection.end;
    std::size_t at = bar.from;
    if (view.isActive) at = view.selection.begin;
    const bool standsOnOne = !view.isActive || isSelected;
    bar.shown = backwards ? previousFound(bar.found, at) : nextFound(bar.found, at + (standsOnOne ? 1 : 0));
    showMatch(bar, view);
}

void updateMatches(FindBar& bar, const std::string& text, CodeView& view) {
    const TextSearch search{bar.words.data(), bar.matchesCase, bar.wholeWords};
    const bool isNew = search.words != bar.search.words || search.matchesCase != bar.search.matchesCase ||
                       search.wholeWords != bar.search.wholeWords;
    bar.search = search;
    bar.found = findAll(text, search);
    if (view.isActive) bar.from = view.selection.begin;
    bar.shown = nextFound(bar.found, bar.from);
    if (isNew) showMatch(bar, view);
}

void replaceOne(FindBar& bar, const EditedFile& file, CodeView& view) {
    if (bar.shown >= bar.found.size()) return;
    const TextRange range = bar.found[bar.shown];
    view.newText = replaced(file.text(), {range}, bar.by.data());
    bar.from = range.begin + std::string_view(bar.by.data()).size();
    bar.found = findAll(*view.newText, bar.search);
    bar.shown = nextFound(bar.found, bar.from);
    showMatch(bar, view);
}

void replaceAll(Ui& ui, FindBar& bar, EditedFile& file, CodeView& view) {
    file.history().endStep();
    view.newText = replaced(file.text(), bar.found, bar.by.data());
    ui.notice = "replaced " + base::counted(bar.found.size(), "match", "matches");
}

bool toggle(Ui& ui, const char* label, bool& on, const char* name, const char* help) {
    const bool wasOn = on;
    if (wasOn) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool isPressed = button(ui, label, name, help);
    if (wasOn) ImGui::PopStyleColor();
    if (isPressed) on = !on;
    ImGui::SameLine();
    return isPressed;
}

/// A text field that keeps the keyboard focus when Enter is pressed. Returns true if it was pressed.
bool findEntry(Ui& ui, const char* hint, std::array<char, 256>& text, bool focus, float width,
               const char* name) {
    ImGui::SetNextItemWidth(width);
    if (focus) giveKeyboardToNext();
    const std::string label = fmt::format("##{}", name);
    const bool isEntered =
        ImGui::InputTextWithHint(label.c_str(), hint, text.data(), text.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    mark(ui, name);
    if (isEntered) ImGui::SetKeyboardFocusHere(-1);
    ImGui::SameLine();
    return isEntered;
}

float widthWithout(const Ui& ui, const char* buttons, int count) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float used = ImGui::CalcTextSize(buttons).x +
                       static_cast<float>(count) * (2 * style.FramePadding.x + style.ItemSpacing.x);
    return std::max(70 * ui.shared.scale, ImGui::GetContentRegionAvail().x - used);
}

void findRow(Ui& ui, FindBar& bar, CodeView& view) {
    const float width = widthWithout(ui, "AaW0000 of 0000<>x", 6);
    const bool isEntered =
        findEntry(ui, "find", bar.words, std::exchange(bar.focus, false), width, "source/find");
    toggle(ui, "Aa", bar.matchesCase, "source/find/case", "Match upper and lower case");
    toggle(ui, "W", bar.wholeWords, "source/find/whole", "Match whole words");
    bool forward = isEntered && !ImGui::GetIO().KeyShift;
    bool backwards = isEntered && ImGui::GetIO().KeyShift;
    backwards = button(ui, "<", "source/find/previous", "Previous match (Shift+F3)") || backwards;
    ImGui::SameLine();
    forward = button(ui, ">", "source/find/next", "Next match (F3)") || forward;
    ImGui::SameLine();
    if (forward || backwards) stepToMatch(bar, view, backwards);
    if (button(ui, "x", "source/find/close", "Close (Esc)")) bar.isOpen = false;
    ImGui::SameLine();
    if (bar.found.empty())
        ImGui::TextDisabled(bar.search.words.empty() ? "" : "no match");
    else
        ImGui::TextDisabled("%zu of %zu", bar.shown + 1, bar.found.size());
}

void replaceRow(Ui& ui, FindBar& bar, EditedFile& file, CodeView& view) {
    const bool isEntered =
        findEntry(ui, "replace with", bar.by, false, widthWithout(ui, "ReplaceAll", 2), "source/find/by");
    ImGui::BeginDisabled(bar.found.empty() || !file.whyReadOnly().empty());
    const bool isPressed = button(ui, "Replace", "source/find/replace");
    ImGui::SameLine();
    const bool isAll = button(ui, "All", "source/find/all");
    ImGui::EndDisabled();
    if (bar.found.empty() || !file.whyReadOnly().empty()) return;
    if (isEntered || isPressed) replaceOne(bar, file, view);
    if (isAll) replaceAll(ui, bar, file, view);
}

void lineRow(Ui& ui, FindBar& bar, CodeView& view) {
    if (std::exchange(bar.focus, false)) giveKeyboardToNext();
    ImGui::SetNextItemWidth(90 * ui.shared.scale);
    wholeEntry("go to line", bar.line, 1, std::numeric_limits<int>::max(), ImGuiInputTextFlags_AutoSelectAll);
    const bool isEntered = ImGui::IsItemDeactivated() && isEnterPressed();
    markField(ui, "source/line", "go to line");
    if (!isEntered) return;
    view.goTo = bar.line;
    bar.asksLine = false;
}

}  // namespace

bool isSame(const std::filesystem::path& a, const std::filesystem::path& b) {
    return a == b || system::wholePath(a) == system::wholePath(b);
}

void fileTabs(Ui& ui, SourceState& panel) {
    if (!ImGui::BeginTabBar("files", ImGuiTabBarFlags_FittingPolicyScroll)) return;
    for (const SourceFile& each : ui.files) {
        const EditedFile* known = knownSource(ui, each.path);
        const bool isChanged = known && known->isChanged();
        const bool isWrong = fileHasError(ui, each.path);
        ImGuiTabItemFlags flags = 0;
        if (panel.follow && each.path == panel.chosen) flags |= ImGuiTabItemFlags_SetSelected;
        if (isWrong) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
        // ImGui leaves no room for its own mark of what is not saved, and would shorten the name.
        const std::string label = each.label + (isChanged ? " *###" : "###") + each.path.generic_string();
        const bool isShown = ImGui::BeginTabItem(label.c_str(), nullptr, flags);
        if (isWrong) ImGui::PopStyleColor();
        mark(ui, "source/file/" + each.label);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s\n%s", each.role.c_str(), each.path.generic_string().c_str());
        if (!isShown) continue;
        if (!panel.follow) panel.chosen = each.path;
        ImGui::EndTabItem();
    }
    panel.follow = false;
    ImGui::EndTabBar();
}

void conflict(Ui& ui, EditedFile& file, CodeView& view) {
    if (!file.hasConflict()) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(asVector(palette().warning), "Another program has changed this file.");
    ImGui::SameLine();
    if (button(ui, "Keep mine", "source/keepMine")) file.keepMine();
    ImGui::SameLine();
    if (button(ui, "Load theirs", "source/takeDisk")) {
        file.takeDisk();
        ++view.generation;
    }
}

void recovered(Ui& ui, EditedFile& file, CodeView& view) {
    const auto found = ui.shared.recovered.find(file.path());
    if (found == ui.shared.recovered.end()) return;
    const std::string words =
        fmt::format("A text of {} was not saved when the window ended.", found->second.when);
    wrappedText(palette().warning, words.c_str());
    const bool takes = button(ui, "Restore", "source/restore");
    ImGui::SameLine();
    const bool leaves = button(ui, "Discard it", "source/discard");
    if (takes) {
        ui.shared.copies.keep(file.path(), found->second.text);
        replaceText(file, std::move(found->second.text));
        ++view.generation;
    }
    if (!takes && !leaves) return;
    SafetyCopies::remove(found->second);
    ui.shared.recovered.erase(found);
}

void replaceText(EditedFile& file, std::string text) {
    file.text() = std::move(text);
    file.history().endStep();
    file.history().record(file.text());
    file.history().endStep();
}

std::string savedNotice(const std::filesystem::path& file) {
    return file.filename().generic_string() + " saved";
}

void saveSource(Ui& ui, const std::filesystem::path& chosen) {
    EditedFile* file = knownSource(ui, chosen);
    if (!file || !file->isChanged()) return;
    if (const Diagnostics problems = file->save(); !problems.empty()) {
        ui.notice = problems.front();
    } else if (file->hasConflict()) {
        ui.notice = {chosen.filename().generic_string() + " was not saved: another program has changed it",
                     true};
    } else {
        ui.notice = savedNotice(chosen);
        ui.requests.saved = chosen;
    }
}

void saveAllSources(Ui& ui) {
    std::vector<std::filesystem::path> changed;
    for (const auto& [path, file] : ui.shared.sources)
        if (file.isChanged()) changed.push_back(path);
    for (const std::filesystem::path& each : changed) {
        saveSource(ui, each);
        if (ui.notice.isError) return;
    }
    if (changed.size() > 1) ui.notice = base::counted(changed.size(), "file") + " saved";
}

void revertSource(EditedFile& file, CodeView& view) {
    file.revert();
    ++view.generation;
}

void openShown(Ui& ui, const EditedFile& file, const CodeView& view) {
    ui.notice = openInEditor({file.path().generic_string(), view.line, view.column});
}

const char* nameOfPlace(SourcePlace place) {
    switch (place) {
        case SourcePlace::beside:
            return "beside the picture";
        case SourcePlace::below:
            return "below the picture";
        case SourcePlace::over:
            return "over the picture";
        case SourcePlace::automatic:
            break;
    }
    return "where there is room";
}

void sourceButtons(Ui& ui, const SourceState& panel, EditedFile& file, CodeView& view) {
    if (isExample(ui.session.path())) {
        if (button(ui, "Save a copy...", "source/copy")) saveSceneAs(ui);
        continueRowForButton("Save");
    }
    ImGui::BeginDisabled(!file.isChanged());
    if (button(ui, "Save", "source/save", "Save the file and update the picture (Ctrl+S)"))
        saveSource(ui, panel.chosen);
    continueRowForButton("Revert");
    if (button(ui, "Revert", "source/revert")) revertSource(file, view);
    ImGui::EndDisabled();
    continueRowForButton("Open in editor");
    if (button(ui, "Open in editor", "source/editor",
               "Open the file at this line in your own editor, which the variable EDITOR names"))
        openShown(ui, file, view);
    continueRowForCheck("Live");
    checkBox(ui, "Live", "source/live", ui.settings.compilesWhileTyping,
             "Update the picture while you type. Files are still written only when you save them");
    placeMenu(ui);
    std::array<char, 192> state{};  // in every frame, so without the heap
    if (file.whyReadOnly().empty())
        fmt::format_to_n(state.data(), state.size() - 1, "{}:{}{}", view.line, view.column,
                         file.isGone()      ? "   removed from the disk"
                         : file.isChanged() ? "   not saved"
                                            : "");
    else
        fmt::format_to_n(state.data(), state.size() - 1, "Read only. {}", file.whyReadOnly());
    constexpr float kLeast = 90;
    const ImVec2 size(ImGui::CalcTextSize(state.data()).x, ImGui::GetFrameHeight());
    continueRow(std::min(size.x, kLeast * ui.shared.scale));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({std::min(size.x, right - at.x), size.y});
    mark(ui, "source/state");
    if (ImGui::IsItemHovered() && !file.whyReadOnly().empty()) {
        ui.frame.hoverText = state.data();
        ImGui::SetTooltip("%s", state.data());
    }
    lineOfText(state.data(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, right, packed(palette().dim));
}

void findBar(Ui& ui, FindBar& bar, EditedFile& file, CodeView& view) {
    if (bar.asksLine) return lineRow(ui, bar, view);
    if (!bar.isOpen) {
        bar.found.clear();
        return;
    }
    updateMatches(bar, file.text(), view);
    findRow(ui, bar, view);
    if (bar.replaces) replaceRow(ui, bar, file, view);
}

void openFind(FindBar& bar, const ShownText& shown, bool replaces) {
    bar.isOpen = bar.focus = true;
    bar.asksLine = false;
    bar.replaces = replaces;
    const EditedFile* file = shown.file;
    if (!file) return;
    const CodeView& view = *shown.view;
    const TextRange& selected = view.selection;
    bar.from = selected.begin;
    if (!view.isActive || selected.begin == selected.end || selected.end > file->text().size()) return;
    const std::string words = file->text().substr(selected.begin, selected.end - selected.begin);
    if (words.size() < bar.words.size() && words.find('\n') == std::string::npos) setField(bar.words, words);
}

void askLine(FindBar& bar, const ShownText& shown) {
    if (!shown.file) return;
    bar.asksLine = bar.focus = true;
    bar.line = shown.view->line;
}

void findAgain(FindBar& bar, const ShownText& shown, bool backwards) {
    if (!shown.file) return;
    if (bar.words[0] == 0) return openFind(bar, shown, false);
    CodeView& view = *shown.view;
    bar.isOpen = true;
    bar.search = {bar.words.data(), bar.matchesCase, bar.wholeWords};
    bar.found = findAll(shown.file->text(), bar.search);
    stepToMatch(bar, view, backwards);
}

bool closeFind(FindBar& bar, const ShownText& shown) {
    if (!shown.file || (!bar.isOpen && !bar.asksLine)) return false;
    const bool isSearch = bar.isOpen && !bar.asksLine;
    CodeView& view = *shown.view;
    if (bar.asksLine)
        bar.asksLine = false;
    else
        bar.isOpen = false;
    if (!view.isActive)
        view.select = isSearch && bar.shown < bar.found.size() ? bar.found[bar.shown] : view.selection;
    return true;
}

void undoTyping(const ShownText& shown, bool again) {
    if (!shown.file || !shown.file->whyReadOnly().empty()) return;
    TextHistory& history = shown.file->history();
    if (again ? !history.canRedo() : !history.canUndo()) return;
    const TextHistory::State state = again ? history.redo() : history.undo();
    shown.view->newText = state.text;
    shown.view->select = TextRange{state.cursor, state.cursor};
}

}  // namespace glibra::view
