// The panel in which the scene and its shaders are edited.

#include "view/window/panels/source_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>

#include "glib/text.h"
#include "view/browse/example_scenes.h"
#include "view/edit/external_editor.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/syntax_colors.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

bool isSame(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failure;
    return a == b || std::filesystem::absolute(a, failure).lexically_normal() ==
                         std::filesystem::absolute(b, failure).lexically_normal();
}

EditedFile& edited(Ui& ui, const std::filesystem::path& path) {
    return ui.shared.sources.try_emplace(path, path).first->second;
}

/// Updates the list of files after the scene was loaded. Files with unsaved text stay in the list even if the
/// scene does not use them any more.
void refresh(Ui& ui) {
    SourcePanel& panel = ui.source;
    if (panel.loaded != ui.session.timesLoaded()) {
        panel.loaded = ui.session.timesLoaded();
        std::vector<SourceFile> files = sourceFiles(ui.session.live());
        for (const SourceFile& old : panel.files) {
            const auto kept = ui.shared.sources.find(old.path);
            const bool isThere = std::any_of(files.begin(), files.end(),
                                             [&](const SourceFile& each) { return each.path == old.path; });
            if (!isThere && kept != ui.shared.sources.end() && kept->second.isChanged())
                files.push_back({old.path, old.label, "no longer used by the scene"});
        }
        panel.files = std::move(files);
        for (auto& [path, file] : ui.shared.sources)
            if (file.lookAtDisk() && !file.hasConflict()) ++panel.views[path].generation;
    }
    const auto isChosen = [&](const SourceFile& each) { return each.path == panel.chosen; };
    if (std::none_of(panel.files.begin(), panel.files.end(), isChosen)) {
        // People edit the last stage most, so begin with it.
        const auto shader = std::find_if(
            panel.files.rbegin(), panel.files.rend(),
            [](const SourceFile& each) { return each.role.find("shader") != std::string::npos; });
        panel.chosen = shader == panel.files.rend() ? panel.files.front().path : shader->path;
        panel.follow = true;
    }
}

/// Puts the cursor at a place, whose column counts bytes.
void goTo(Ui& ui, const std::filesystem::path& path, const Place& place) {
    const std::string& text = edited(ui, path).text();
    std::size_t at = 0;
    for (int line = 1; line < place.line; ++line) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) break;
        at = end + 1;
    }
    const std::size_t end = std::min(text.find('\n', at), text.size());
    at = std::min(end, at + static_cast<std::size_t>(std::max(1, place.column)) - 1);
    ui.source.views[path].select = TextRange{at, at};
}

void takeGoTo(Ui& ui) {
    SourcePanel& panel = ui.source;
    const auto place = std::exchange(panel.goTo, std::nullopt);
    if (!place) return;
    for (const SourceFile& each : panel.files)
        if (isSame(each.path, place->file)) {
            panel.chosen = each.path;
            panel.follow = true;
            goTo(ui, each.path, *place);
            return;
        }
    ui.notice = {place->file + " is not a file of this scene", true};
}

bool fileHasError(const Ui& ui, const std::filesystem::path& file) {
    return std::any_of(ui.session.diagnostics().begin(), ui.session.diagnostics().end(),
                       [&](const Diagnostic& each) {
                           return each.severity == Severity::error && isSame(each.place.file, file);
                       });
}

void fileTabs(Ui& ui) {
    SourcePanel& panel = ui.source;
    if (!ImGui::BeginTabBar("files", ImGuiTabBarFlags_FittingPolicyScroll)) return;
    for (const SourceFile& each : panel.files) {
        const auto known = ui.shared.sources.find(each.path);
        const bool isChanged = known != ui.shared.sources.end() && known->second.isChanged();
        const bool isWrong = fileHasError(ui, each.path);
        ImGuiTabItemFlags flags = isChanged ? ImGuiTabItemFlags_UnsavedDocument : 0;
        if (panel.follow && each.path == panel.chosen) flags |= ImGuiTabItemFlags_SetSelected;
        if (isWrong) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
        const bool isShown =
            ImGui::BeginTabItem((each.label + "###" + each.path.string()).c_str(), nullptr, flags);
        if (isWrong) ImGui::PopStyleColor();
        mark(ui, "source/file/" + each.label);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\n%s", each.role.c_str(), each.path.c_str());
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
    if (ImGui::Button("Keep mine")) file.keepMine();
    mark(ui, "source/keepMine");
    ImGui::SameLine();
    if (ImGui::Button("Load theirs")) {
        file.takeDisk();
        ++view.generation;
    }
    mark(ui, "source/takeDisk");
}

void sourceButtons(Ui& ui, EditedFile& file, CodeView& view) {
    if (isExample(ui.session.path())) {
        if (ImGui::Button("Save a copy...")) saveSceneAs(ui);
        mark(ui, "source/copy");
        continueRowForButton("Save");
    }
    ImGui::BeginDisabled(!file.isChanged());
    if (ImGui::Button("Save")) saveSource(ui);
    mark(ui, "source/save");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Save the file and update the picture (Ctrl+S)");
    continueRowForButton("Revert");
    if (ImGui::Button("Revert")) {
        file.revert();
        ++view.generation;
    }
    ImGui::EndDisabled();
    mark(ui, "source/revert");
    continueRowForButton("Open in editor");
    if (ImGui::Button("Open in editor"))
        ui.notice = openInEditor({file.path().string(), view.line, view.column});
    mark(ui, "source/editor");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Open the file at this line in your own editor, which the variable EDITOR names");
    continueRowForCheck("Live");
    ImGui::Checkbox("Live", &ui.settings.compilesWhileTyping);
    mark(ui, "source/live");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "Update the picture while you type. Files are still written only when you save them");
    std::array<char, 192> state{};  // in every frame, so without the heap
    if (file.whyReadOnly().empty())
        fmt::format_to_n(state.data(), state.size() - 1, "{}:{}{}", view.line, view.column,
                         file.isChanged() ? "   not saved" : "");
    else
        fmt::format_to_n(state.data(), state.size() - 1, "Read only. {}", file.whyReadOnly());
    constexpr float kLeast = 90;
    const ImVec2 size(ImGui::CalcTextSize(state.data()).x, ImGui::GetFrameHeight());
    continueRow(std::min(size.x, kLeast * ui.scale));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({std::min(size.x, right - at.x), size.y});
    mark(ui, "source/state");
    if (ImGui::IsItemHovered() && !file.whyReadOnly().empty()) {
        ui.hoverText = state.data();
        ImGui::SetTooltip("%s", state.data());
    }
    ImGui::PushStyleColor(ImGuiCol_Text, packed(palette().dim));
    lineOfText(state.data(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, right);
    ImGui::PopStyleColor();
}

void sourceContent(Ui& ui) {
    SourcePanel& panel = ui.source;
    EditedFile& file = edited(ui, panel.chosen);
    CodeView& view = panel.views[panel.chosen];
    sourceButtons(ui, file, view);
    conflict(ui, file, view);
    findBar(ui, file, view);
    std::vector<CodeMark> marks;
    for (const Diagnostic& each : ui.session.diagnostics())
        if (each.severity != Severity::note && isSame(each.place.file, file.path()))
            marks.push_back({each.place.line, each.place.column, each.severity, each.text});
    std::stable_sort(marks.begin(), marks.end(), [](const CodeMark& a, const CodeMark& b) {
        return a.line != b.line ? a.line < b.line : a.severity > b.severity;
    });
    const std::size_t messages = ui.session.diagnostics().size();
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float below = messages == 0 ? 0
                                      : std::min(ImGui::GetContentRegionAvail().y * .4F,
                                                 line * (2 * static_cast<float>(messages) + .5F));
    const CodeLanguage language =
        glib::sameWord(file.path().extension().string(), ".glib") ? CodeLanguage::glib : CodeLanguage::glsl;
    const FindBar& find = panel.find;
    const int cursorBefore = view.cursor;
    assistKeys(ui, file, view);
    const bool isChanged =
        codeEditor(panel.chosen.string().c_str(), file.text(), view, {marks, find.found, find.shown},
                   language, !file.whyReadOnly().empty(), below);
    mark(ui, "source/text");
    if (isChanged)
        file.history().record(file.text());
    else if (view.cursor != cursorBefore)
        file.history().endStep();
    panel.keepsKeyboard = panel.keepsKeyboard || view.isActive;
    ui.sourceState = {panel.chosen.string(), view.line,        view.column,
                      view.isActive,         file.isChanged(), file.hasConflict()};
    assist(ui, file, view, isChanged);
    if (messages == 0) return;
    ImGui::BeginChild("messages");
    ImGui::Separator();
    messageList(ui, file.path());
    ImGui::EndChild();
}

/// Gives the session the texts that are not saved, if they are to be compiled while the user types. It does
/// so when the user pauses.
void compileWhileTyping(Ui& ui) {
    constexpr double kPause = .15;  // seconds
    SourcePanel& panel = ui.source;
    std::map<std::filesystem::path, std::string> wanted;
    for (const SourceFile& each : panel.files) {
        const auto known = ui.shared.sources.find(each.path);
        if (ui.settings.compilesWhileTyping && known != ui.shared.sources.end() && known->second.isChanged())
            wanted.emplace(each.path, known->second.text());
    }
    const auto& compiled = ui.session.texts();
    if (wanted == compiled) return;
    const auto isInEffect = [&](const std::filesystem::path& path, const std::string& text) {
        const auto known = ui.shared.sources.find(path);
        return known != ui.shared.sources.end() && known->second.text() == text;
    };
    // Files that were saved have the compiled text already.
    const bool wereSaved = std::all_of(wanted.begin(), wanted.end(),
                                       [&](const auto& each) {
                                           const auto same = compiled.find(each.first);
                                           return same != compiled.end() && same->second == each.second;
                                       }) &&
                           std::all_of(compiled.begin(), compiled.end(),
                                       [&](const auto& each) { return isInEffect(each.first, each.second); });
    if (wereSaved) return ui.session.setTexts(std::move(wanted));
    const double now = ImGui::GetTime();
    if (wanted != panel.typedTexts) {
        panel.typedTexts = std::move(wanted);
        panel.typedAt = now;
    }
    if (now - panel.typedAt < kPause) {
        ui.needsFrames = true;
        return;
    }
    ui.session.setTexts(panel.typedTexts);
    ui.requests.reload = true;
    ui.needsFrames = true;
}

/// A click on the picture or the panel ends typing. Tool windows may be clicked: Esc closes them.
void noticeClicks(Ui& ui) {
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsMouseClicked(ImGuiMouseButton_Right))
        return;
    const ImGuiWindow* under = ImGui::GetCurrentContext()->HoveredWindow;
    const std::string_view owner = under ? under->RootWindow->Name : "";
    if (owner.empty() || owner == "Controls" || owner == "Scenes") ui.source.keepsKeyboard = false;
}

}  // namespace

void returnToText(Ui& ui) {
    if (!ui.settings.showSource || !ui.source.keepsKeyboard) return;
    CodeView& view = ui.source.views[ui.source.chosen];
    if (!view.isActive && !view.select) view.select = view.selection;
}

void saveSource(Ui& ui) {
    const auto found = ui.shared.sources.find(ui.source.chosen);
    if (found == ui.shared.sources.end() || !found->second.isChanged()) return;
    const std::string name = ui.source.chosen.filename().string();
    const Diagnostics problems = found->second.save();
    if (!problems.empty())
        ui.notice = problems.front();
    else if (found->second.hasConflict())
        ui.notice = {name + " was not saved: another program has changed it", true};
    else
        ui.notice = name + " saved";
    if (problems.empty() && !found->second.hasConflict()) ui.requests.saved = ui.source.chosen;
}

void showSource(Ui& ui, const Place& place) {
    ui.settings.showSource = true;
    ui.source.goTo = place;
}

void sourcePanel(Ui& ui, Rectangle& free) {
    ui.sourceState = {};
    if (!ui.session.hasScene()) return;
    compileWhileTyping(ui);
    noticeClicks(ui);
    if (!ui.settings.showSource) {
        ui.source.assist.isOpen = ui.source.keepsKeyboard = false;
        return;
    }
    refresh(ui);
    takeGoTo(ui);
    // Beside the picture if there is room for both, otherwise below it.
    const bool isBeside = free[2] >= 1100 * ui.scale;
    float& extent = isBeside ? ui.settings.sourceWidth : ui.settings.sourceHeight;
    const float room = isBeside ? free[2] : free[3];
    const float least = std::min(room * .5F, 220 * ui.scale);
    const float most = std::max(least, room * .75F);
    if (extent <= 0) extent = room * (isBeside ? .5F : .45F);
    extent = std::clamp(extent, least, most);
    const ImVec2 size = isBeside ? ImVec2(extent, free[3]) : ImVec2(free[2], extent);
    if (isBeside) {
        ImGui::SetNextWindowPos({free[0], free[1]});
        ImGui::SetNextWindowSizeConstraints({least, size.y}, {most, size.y});
    } else {
        ImGui::SetNextWindowPos({free[0], free[1] + free[3]}, ImGuiCond_Always, {0, 1});
        ImGui::SetNextWindowSizeConstraints({size.x, least}, {size.x, most});
    }
    // Two ImGui windows, since each position has its own size.
    const char* name = isBeside ? "Source" : "Source below";
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    if (ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                         ImGuiWindowFlags_NoScrollWithMouse)) {
        fileTabs(ui);
        sourceContent(ui);
        // Moving the keyboard focus to the text scrolls this window too.
        ImGui::SetScrollX(0);
        ImGui::SetScrollY(0);
    }
    extent = isBeside ? ImGui::GetWindowWidth() : ImGui::GetWindowHeight();
    ImGui::End();
    free[isBeside ? 2 : 3] -= extent;
    if (isBeside) free[0] += extent;
}

}  // namespace glibra::view
