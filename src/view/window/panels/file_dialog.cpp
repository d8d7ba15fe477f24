// The dialog that opens a scene: folders, scenes and recent scenes.

#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;
constexpr const char* kTitle = "Open a scene";

void showFolder(FileDialog& dialog, const fs::path& folder) {
    dialog.list = listFolder(folder, ".glib");
    dialog.entry = {};
    dialog.focusEntry = true;
}

fs::path homeFolder() {
    const char* home = std::getenv("HOME");
    return home ? fs::path(home) : fs::path();
}

void openAndClose(Ui& ui, const fs::path& file) {
    ui.requests.open = file;
    ui.requests.inNewTab = ui.shared.dialog.inNewTab || ImGui::GetIO().KeyCtrl;
    ImGui::CloseCurrentPopup();
}

/// Shows the typed folder or opens the typed file. Paths are relative to the shown folder.
void openEntry(Ui& ui) {
    FileDialog& dialog = ui.shared.dialog;
    const std::string text = dialog.entry.data();
    if (text.empty()) return;
    fs::path path = dialog.list.folder / text;
    if (text == "~" || text.starts_with("~/"))
        path = homeFolder() / text.substr(std::min<std::size_t>(2, text.size()));
    std::error_code failure;
    if (fs::is_directory(path, failure)) return showFolder(dialog, path);
    openAndClose(ui, path);
}

void folderLink(Ui& ui, const char* label, const fs::path& folder) {
    if (folder.empty()) return;
    if (ImGui::Selectable(label)) showFolder(ui.shared.dialog, folder);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
}

void places(Ui& ui) {
    ImGui::TextDisabled("Folders");
    folderLink(ui, "Home", homeFolder());
    std::error_code failure;
    folderLink(ui, "Current folder", fs::current_path(failure));
    if (ui.session.hasScene()) folderLink(ui, "Folder of this scene", ui.session.path().parent_path() / ".");
    ImGui::Spacing();
    ImGui::TextDisabled("Recent scenes");
    int index = 0;
    for (const std::string& each : ui.settings.recent) {
        ImGui::PushID(index);
        const fs::path path = each;
        const std::string label = path.filename().string();
        if (ImGui::Selectable(label.c_str())) openAndClose(ui, path);
        mark(ui, "dialog/recent/" + std::to_string(index));
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", each.c_str());
        ImGui::PopID();
        ++index;
    }
}

void folderList(Ui& ui) {
    FileDialog& dialog = ui.shared.dialog;
    if (!dialog.list.problem.empty()) ImGui::TextWrapped("%s", dialog.list.problem.c_str());
    fs::path next;
    if (dialog.list.folder.has_relative_path()) {
        if (ImGui::Selectable("../")) next = dialog.list.folder.parent_path();
        mark(ui, "dialog/up");
    }
    for (const FolderEntry& each : dialog.list.entries) {
        const std::string label = each.isFolder ? each.name + "/" : each.name;
        const bool isChosen = each.name == dialog.entry.data();
        if (ImGui::Selectable(label.c_str(), isChosen,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
            const fs::path path = dialog.list.folder / each.name;
            if (each.isFolder)
                next = path;
            else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
                openAndClose(ui, path);
            else
                dialog.entry[each.name.copy(dialog.entry.data(), dialog.entry.size() - 1)] = 0;
        }
        mark(ui, "dialog/entry/" + each.name);
    }
    if (dialog.list.entries.empty() && dialog.list.problem.empty())
        ImGui::TextDisabled("This folder has no scenes (.glib) and no folders.");
    if (!next.empty()) showFolder(dialog, next);
}

void entry(Ui& ui) {
    FileDialog& dialog = ui.shared.dialog;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttons = ImGui::CalcTextSize("OpenOpen in new tabCancel").x + 6 * style.FramePadding.x +
                          3 * style.ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(120 * ui.scale, ImGui::GetContentRegionAvail().x - buttons));
    if (std::exchange(dialog.focusEntry, false)) ImGui::SetKeyboardFocusHere();
    const bool isEntered =
        ImGui::InputTextWithHint("##path", "file name or path", dialog.entry.data(), dialog.entry.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, "scene/path");
    ImGui::SameLine();
    ImGui::BeginDisabled(dialog.entry[0] == 0);
    const bool isOpened = ImGui::Button("Open");
    mark(ui, "dialog/open");
    ImGui::SameLine();
    const bool isOpenedInTab = ImGui::Button("Open in new tab");
    mark(ui, "dialog/openInTab");
    ImGui::EndDisabled();
    if (isOpenedInTab) dialog.inNewTab = true;
    if (isEntered || isOpened || isOpenedInTab) openEntry(ui);
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        ImGui::CloseCurrentPopup();
    mark(ui, "dialog/cancel");
}

}  // namespace

void fileDialog(Ui& ui) {
    FileDialog& dialog = ui.shared.dialog;
    if (std::exchange(dialog.isWanted, false)) {
        const fs::path usual = ui.session.hasScene() ? ui.session.path().parent_path()
                               : ui.settings.recent.empty()
                                   ? fs::path(".")
                                   : fs::path(ui.settings.recent.front()).parent_path();
        const fs::path wanted = std::exchange(dialog.folder, {});
        showFolder(dialog, wanted.empty() ? usual : wanted);
        ImGui::OpenPopup(kTitle);
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {.5F, .5F});
    ImGui::SetNextWindowSize(
        {std::min(760 * ui.scale, screen.x - 30), std::min(520 * ui.scale, screen.y - 30)},
        ImGuiCond_Appearing);
    bool stays = true;
    if (!ImGui::BeginPopupModal(kTitle, &stays, ImGuiWindowFlags_NoScrollbar)) return;
    const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("places", {std::min(200 * ui.scale, ImGui::GetContentRegionAvail().x * .35F), -below});
    places(ui);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextWrapped("%s", dialog.list.folder.c_str());
    ImGui::BeginChild("files", {0, -below}, true);
    folderList(ui);
    ImGui::EndChild();
    ImGui::EndGroup();
    entry(ui);
    ImGui::EndPopup();
}

}  // namespace glibra::view
