#include "view/window/panels/source_header.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <system_error>

#include "view/browse/example_scenes.h"
#include "view/edit/external_editor.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/syntax_colors.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

bool fileHasError(const Ui& ui, const std::filesystem::path& file) {
    return std::any_of(ui.session.diagnostics().begin(), ui.session.diagnostics().end(),
                       [&](const Diagnostic& each) {
                           return each.severity == Severity::error && isSame(each.place.file, file);
                       });
}

}  // namespace

bool isSame(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failure;
    return a == b || std::filesystem::absolute(a, failure).lexically_normal() ==
                         std::filesystem::absolute(b, failure).lexically_normal();
}

void fileTabs(Ui& ui, SourceState& panel) {
    if (!ImGui::BeginTabBar("files", ImGuiTabBarFlags_FittingPolicyScroll)) return;
    for (const SourceFile& each : ui.files) {
        const auto known = ui.shared.sources.find(each.path);
        const bool isChanged = known != ui.shared.sources.end() && known->second.isChanged();
        const bool isWrong = fileHasError(ui, each.path);
        ImGuiTabItemFlags flags = isChanged ? ImGuiTabItemFlags_UnsavedDocument : 0;
        if (panel.follow && each.path == panel.chosen) flags |= ImGuiTabItemFlags_SetSelected;
        if (isWrong) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
        // ImGui leaves no room for the point of what is not saved.
        const std::string label = each.label + (isChanged ? "    ###" : "###") + each.path.string();
        const bool isShown = ImGui::BeginTabItem(label.c_str(), nullptr, flags);
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

void recovered(Ui& ui, EditedFile& file, CodeView& view) {
    const auto found = ui.shared.recovered.find(file.path());
    if (found == ui.shared.recovered.end()) return;
    const std::string words =
        fmt::format("A text of {} was not saved when the window ended.", found->second.when);
    ImGui::PushStyleColor(ImGuiCol_Text, packed(palette().warning));
    ImGui::TextWrapped("%s", words.c_str());
    ImGui::PopStyleColor();
    const bool takes = ImGui::Button("Restore");
    mark(ui, "source/restore");
    ImGui::SameLine();
    const bool leaves = ImGui::Button("Discard it");
    mark(ui, "source/discard");
    if (takes) {
        file.text() = std::move(found->second.text);
        file.history().endStep();
        file.history().record(file.text());
        file.history().endStep();
        ++view.generation;
    }
    if (leaves) forgetText(recoveryFolder(), file.path());
    if (takes || leaves) ui.shared.recovered.erase(found);
}

std::string savedNotice(const std::filesystem::path& file) {
    return file.filename().string() + " saved";
}

void saveSource(Ui& ui, const std::filesystem::path& chosen) {
    const auto found = ui.shared.sources.find(chosen);
    if (found == ui.shared.sources.end() || !found->second.isChanged()) return;
    const std::string name = chosen.filename().string();
    const Diagnostics problems = found->second.save();
    if (!problems.empty())
        ui.notice = problems.front();
    else if (found->second.hasConflict())
        ui.notice = {name + " was not saved: another program has changed it", true};
    else
        ui.notice = savedNotice(chosen);
    if (problems.empty() && !found->second.hasConflict()) ui.requests.saved = chosen;
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
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Beside, below or over the picture (Ctrl+Shift+E)");
    if (!ImGui::BeginPopup("place")) return;
    for (const SourcePlace each :
         {SourcePlace::automatic, SourcePlace::beside, SourcePlace::below, SourcePlace::over}) {
        if (ImGui::MenuItem(nameOfPlace(each), nullptr, each == ui.settings.sourcePlace))
            ui.settings.sourcePlace = each;
        mark(ui, "source/place/{}", nameOfPlace(each));
    }
    ImGui::EndPopup();
}

}  // namespace

void sourceButtons(Ui& ui, const SourceState& panel, EditedFile& file, CodeView& view) {
    if (isExample(ui.session.path())) {
        if (ImGui::Button("Save a copy...")) saveSceneAs(ui);
        mark(ui, "source/copy");
        continueRowForButton("Save");
    }
    ImGui::BeginDisabled(!file.isChanged());
    if (ImGui::Button("Save")) saveSource(ui, panel.chosen);
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
    checkBox("Live", &ui.settings.compilesWhileTyping);
    mark(ui, "source/live");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
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
    ImGui::PushStyleColor(ImGuiCol_Text, packed(palette().dim));
    lineOfText(state.data(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, right);
    ImGui::PopStyleColor();
}

}  // namespace glibra::view
