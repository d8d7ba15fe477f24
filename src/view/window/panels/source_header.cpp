#include "view/window/panels/source_header.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/text.h"
#include "system/folder.h"
#include "view/edit/example_folders.h"
#include "view/edit/external_editor.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/syntax_colors.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

bool fileHasError(const Ui& ui, const std::filesystem::path& file) {
    return std::ranges::any_of(ui.session.diagnostics(), [&](const Diagnostic& each) {
        return each.severity == Severity::error && isSame(each.place.file, file);
    });
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

namespace {

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

}  // namespace

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

}  // namespace glibra::view
