// The dialog that opens a scene, or asks for another file or folder.

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "system/places.h"
#include "view/browse/example_scenes.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

// The list of recent scenes, as the welcome and the dialog that opens a scene have it.

/// A row for each of the first `most` recent scenes: its name and its folder, which stands beside the name
/// or, with `isNarrow`, below it. A scene whose file is gone cannot be chosen; its row says so and has a
/// button that removes it. `name` is that of the list, for mark(). Returns the chosen scene; empty: none.
std::filesystem::path recentScenes(Ui& ui, std::size_t most, const std::string& name, bool isNarrow) {
    std::vector<std::string>& recent = ui.settings.recent;
    std::filesystem::path chosen;
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < std::min(most, recent.size()); ++i) {
        const std::filesystem::path file = recent[i];
        std::error_code failure;
        const bool isGone = !std::filesystem::is_regular_file(file, failure);
        ImGui::PushID(static_cast<int>(i));
        if (isGone)
            ImGui::TextDisabled("%s", file.filename().generic_string().c_str());
        else if (ImGui::Selectable(file.filename().generic_string().c_str()))
            chosen = file;
        if (isGone)
            markPlace(ui, name + "/gone/" + std::to_string(i));
        else
            mark(ui, "{}/{}", name, i);
        tooltip(file.generic_string().c_str());
        if (isNarrow)
            ImGui::Indent();
        else
            ImGui::SameLine();
        const std::string words = isGone ? "the file is gone" : file.parent_path().generic_string();
        const float width =
            isNarrow ? ImGui::GetContentRegionAvail().x : std::max(80.F, ui.frame.room[2] * .6F);
        ImGui::TextDisabled("%s", shortened(words, width).c_str());
        markPlace(ui, name + "/folder/" + std::to_string(i));
        if (isGone) {
            besideIfRoom(ImGui::CalcTextSize("Remove").x + 2 * ImGui::GetStyle().FramePadding.x);
            if (ImGui::SmallButton("Remove")) removed = i;
            mark(ui, "{}/remove/{}", name, i);
            tooltip("Takes it out of this list");
        }
        if (isNarrow) ImGui::Unindent();
        ImGui::PopID();
    }
    if (removed) recent.erase(recent.begin() + static_cast<std::ptrdiff_t>(*removed));
    return chosen;
}

namespace fs = std::filesystem;
constexpr const char* kId = "###file dialog";

struct FileDialog {
    bool isWanted = false;  ///< opens in this frame
    bool inNewTab = false;  ///< the chosen scene gets its own tab
    bool focusEntry = false;
    fs::path folder;  ///< where to begin; empty: the scene's folder
    FolderList list;
    std::array<char, 4096> entry{};
    std::optional<FileQuestion> question;  ///< nothing: a scene to open
    std::string existing;                  ///< the entry for which the dialog offers to replace the file
    std::string problem;                   ///< why the last entry was refused
};

FileQuestion::Kind kindOf(const FileDialog& dialog) {
    return dialog.question ? dialog.question->kind : FileQuestion::Kind::open;
}

/// The proposed name of a file to save stays in every folder.
void showFolder(FileDialog& dialog, const fs::path& folder) {
    dialog.list = listFolder(folder, dialog.question ? dialog.question->endings : ".glib");
    if (kindOf(dialog) == FileQuestion::Kind::folder)
        std::erase_if(dialog.list.entries, [](const FolderEntry& each) { return !each.isFolder; });
    if (kindOf(dialog) != FileQuestion::Kind::save) setField(dialog.entry, "");
    dialog.existing.clear();
    dialog.problem.clear();
    dialog.focusEntry = true;
}

void openAndClose(Ui& ui, const FileDialog& dialog, const fs::path& file) {
    ui.requests.open = file;
    ui.requests.inNewTab = dialog.inNewTab || ImGui::GetIO().KeyCtrl;
    ImGui::CloseCurrentPopup();
}

void answer(Ui& ui, FileDialog& dialog, const fs::path& path) {
    if (!dialog.question) return openAndClose(ui, dialog, path);
    std::error_code failure;
    if (kindOf(dialog) == FileQuestion::Kind::save && fs::exists(path, failure) && dialog.existing != path) {
        dialog.existing = path.generic_string();
        dialog.problem.clear();
        return;
    }
    dialog.problem = dialog.question->chosen(ui, path);
    if (!dialog.problem.empty()) {
        dialog.existing.clear();
        return;
    }
    dialog.question.reset();
    ImGui::CloseCurrentPopup();
}

/// Shows the typed folder or takes the typed file. Paths are relative to the shown folder.
void takeEntry(Ui& ui, FileDialog& dialog, bool isEntered) {
    const std::string text = dialog.entry.data();
    if (text.empty() && kindOf(dialog) != FileQuestion::Kind::folder) return;
    fs::path path = dialog.list.folder / text;
    if (text == "~" || text.starts_with("~/"))
        path = system::homeFolder() / text.substr(std::min<std::size_t>(2, text.size()));
    if (text.empty()) path = dialog.list.folder;
    std::error_code failure;
    const bool isFolder = fs::is_directory(path, failure);
    if (isFolder && (kindOf(dialog) != FileQuestion::Kind::folder || (isEntered && !text.empty())))
        return showFolder(dialog, path);
    answer(ui, dialog, path.lexically_normal());
}

void folderLink(FileDialog& dialog, const char* label, const fs::path& folder) {
    if (folder.empty()) return;
    if (ImGui::Selectable(label, false, ImGuiSelectableFlags_DontClosePopups)) showFolder(dialog, folder);
    tooltip(folder.generic_string().c_str());
}

void places(Ui& ui, FileDialog& dialog) {
    ImGui::TextDisabled("Folders");
    folderLink(dialog, "Home", system::homeFolder());
    std::error_code failure;
    folderLink(dialog, "Current folder", fs::current_path(failure));
    if (ui.session.hasScene())
        folderLink(dialog, "Folder of this scene", ui.session.path().parent_path() / ".");
    if (dialog.question) return;
    ImGui::Spacing();
    ImGui::TextDisabled("Recent scenes");
    const fs::path chosen = recentScenes(ui, ui.settings.recent.size(), "dialog/recent", true);
    if (!chosen.empty()) openAndClose(ui, dialog, chosen);
}

void folderList(Ui& ui, FileDialog& dialog) {
    if (!dialog.list.problem.empty()) ImGui::TextWrapped("%s", dialog.list.problem.c_str());
    fs::path next, taken;
    if (dialog.list.folder.has_relative_path()) {
        if (ImGui::Selectable("../", false, ImGuiSelectableFlags_DontClosePopups))
            next = dialog.list.folder.parent_path();
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
                taken = path;
            else
                setField(dialog.entry, each.name);
        }
        mark(ui, "dialog/entry/" + each.name);
    }
    if (dialog.list.entries.empty() && dialog.list.problem.empty())
        ImGui::TextDisabled(dialog.question ? "This folder has no such files and no folders."
                                            : "This folder has no scenes (.glib) and no folders.");
    if (!next.empty()) showFolder(dialog, next);
    if (!taken.empty()) answer(ui, dialog, taken);
}

/// The buttons right of the entry. Returns true if the user takes the entry.
bool dialogButtons(Ui& ui, FileDialog& dialog) {
    ImGui::SameLine();
    ImGui::BeginDisabled(dialog.entry[0] == 0 && kindOf(dialog) != FileQuestion::Kind::folder);
    const char* label = !dialog.existing.empty() ? "Replace"
                        : dialog.question        ? dialog.question->button.c_str()
                                                 : "Open";
    bool isTaken = button(ui, label, "dialog/open");
    if (!dialog.question) {
        ImGui::SameLine();
        if (button(ui, "Open in new tab", "dialog/openInTab")) isTaken = dialog.inNewTab = true;
    }
    ImGui::EndDisabled();
    return isTaken;
}

void pathEntry(Ui& ui, FileDialog& dialog) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string words =
        dialog.question ? dialog.question->button + "ReplaceCancel" : "OpenOpen in new tabCancel";
    const float width =
        ImGui::CalcTextSize(words.c_str()).x + 6 * style.FramePadding.x + 3 * style.ItemSpacing.x;
    ImGui::SetNextItemWidth(std::max(120 * ui.shared.scale, ImGui::GetContentRegionAvail().x - width));
    if (std::exchange(dialog.focusEntry, false)) giveKeyboardToNext();
    const std::string before = dialog.entry.data();
    const bool isEntered =
        ImGui::InputTextWithHint("##path", "file name or path", dialog.entry.data(), dialog.entry.size(),
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    mark(ui, "scene/path");
    if (before != dialog.entry.data()) {
        dialog.existing.clear();
        dialog.problem.clear();
    }
    const bool isPressed = dialogButtons(ui, dialog);
    if (isEntered || isPressed) takeEntry(ui, dialog, isEntered && !isPressed);
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || isKeyPressed(GLFW_KEY_ESCAPE)) {
        dialog.question.reset();
        ImGui::CloseCurrentPopup();
    }
    mark(ui, "dialog/cancel");
}

/// The folder of the scene, or of the last one whose folder is still there.
fs::path usualFolder(const Ui& ui) {
    if (ui.session.hasScene()) return ui.session.path().parent_path();
    std::error_code failure;
    for (const std::string& each : ui.settings.recent)
        if (const fs::path folder = fs::path(each).parent_path(); fs::is_directory(folder, failure))
            return folder;
    return ".";
}

/// Sets the dialog up for what is wanted.
void beginDialog(const Ui& ui, FileDialog& dialog) {
    const fs::path wanted = std::exchange(dialog.folder, {});
    if (dialog.question) setField(dialog.entry, dialog.question->entry);
    showFolder(dialog, wanted.empty() ? usualFolder(ui) : wanted);
    ImGui::OpenPopup(kId);
}

/// The sentence above the list: why the entry was refused, that a file exists, or what to choose.
void hint(Ui& ui, const FileDialog& dialog) {
    if (!dialog.problem.empty()) {
        wrappedText(palette().error, dialog.problem.c_str());
        mark(ui, "dialog/problem");
    } else if (!dialog.existing.empty())
        ImGui::TextWrapped("%s exists. Press Replace, or type another name.",
                           fs::path(dialog.existing).filename().generic_string().c_str());
    else if (dialog.question && !dialog.question->hint.empty())
        ImGui::TextWrapped("%s", dialog.question->hint.c_str());
}

void fileDialog(Ui& ui, FileDialog& dialog) {
    if (std::exchange(dialog.isWanted, false) && !ImGui::IsPopupOpen(kId)) beginDialog(ui, dialog);
    if (!ImGui::IsPopupOpen(kId)) {
        dialog.question.reset();
        return;
    }
    centreNextWindow(ImGuiCond_Appearing);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSize(
        {std::min(760 * ui.shared.scale, screen.x - 30), std::min(520 * ui.shared.scale, screen.y - 30)},
        ImGuiCond_Appearing);
    bool stays = true;
    const std::string title = (dialog.question ? dialog.question->title : "Open a scene") + kId;
    if (!ImGui::BeginPopupModal(title.c_str(), &stays, ImGuiWindowFlags_NoScrollbar)) return;
    hint(ui, dialog);
    const float below = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("places",
                      {std::min(200 * ui.shared.scale, ImGui::GetContentRegionAvail().x * .35F), -below});
    places(ui, dialog);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextWrapped("%s", dialog.list.folder.generic_string().c_str());
    ImGui::BeginChild("files", {0, -below}, true);
    folderList(ui, dialog);
    ImGui::EndChild();
    ImGui::EndGroup();
    pathEntry(ui, dialog);
    ImGui::EndPopup();
}

class FileDialogPanel final : public Panel {
  public:
    void update(Ui& ui) override {
        if (!ui.wanted.file || ImGui::IsPopupOpen(kId)) return;
        dialog_.isWanted = true;
        dialog_.inNewTab = ui.wanted.file->inNewTab;
        dialog_.question = std::move(ui.wanted.file->question);
        dialog_.folder = std::move(ui.wanted.file->folder);
    }
    void show(Ui& ui) override { fileDialog(ui, dialog_); }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["folder"] = dialog_.list.folder.generic_string();
        state["dialog"] = dialog_.question ? dialog_.question->title : std::string();
    }

  private:
    FileDialog dialog_;
};

// What the window offers while it has no scene.

void welcome(Ui& ui) {
    if (ui.session.hasScene() || toolWindow(ui, "examples").isOpen) return;
    const Rectangle& room = ui.frame.room;
    // Below the hint that stands in the middle.
    ImGui::SetNextWindowPos(
        {room[0] + room[2] / 2, room[1] + room[3] / 2 + 2 * ImGui::GetTextLineHeightWithSpacing()},
        ImGuiCond_Always, {.5F, 0});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus |
                                        ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("##welcome", nullptr, kFlags)) {
        if (button(ui, "New scene...", "welcome/new")) askEmptyScene(ui);
        ImGui::SameLine();
        if (button(ui, "Open...", "welcome/open")) openDialog(ui, false);
        ImGui::SameLine();
        if (button(ui, "Examples", "welcome/examples")) toolWindow(ui, "examples").isOpen = true;
        constexpr std::size_t kMost = 8;
        if (!ui.settings.recent.empty()) ImGui::TextDisabled("Recent scenes");
        const std::filesystem::path chosen = recentScenes(ui, kMost, "welcome/recent", false);
        if (!chosen.empty()) ui.requests.open = chosen;
    }
    ImGui::End();
}

}  // namespace

const PanelRow kFileDialogRow{
    .name = "fileDialog", .place = PanelPlace::floating, .make = make<FileDialogPanel>, .isShared = true};

const PanelRow kWelcomeRow{.name = "welcome", .place = PanelPlace::floating, .make = make<Drawn<welcome>>};

}  // namespace glibra::view
