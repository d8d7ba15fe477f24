// The menu "File": new scenes from templates, opening, saving, copies of examples, hardcopies.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "image/file.h"
#include "view/browse/example_scenes.h"
#include "view/edit/save_values.h"
#include "view/edit/scene_copy.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The text of the session's scene as it would be saved: with unsaved edits, or else with the values.
Result<std::string> textToSave(const Ui& ui) {
    const auto edited = ui.shared.sources.find(ui.session.path());
    if (edited != ui.shared.sources.end() && edited->second.isChanged()) return edited->second.text();
    const fs::path& path = ui.session.path();
    const auto bytes = image::readFile(path, {path.string(), {path.string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    return withValues(
        withFiles({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, ui.session.chosenFiles()),
        ui.session.knobs());
}

/// Where users keep their own scenes: beside this one, unless it is an example.
fs::path ownFolder(const Ui& ui) {
    if (ui.session.hasScene() && !isExample(ui.session.path())) return ui.session.path().parent_path();
    for (const std::string& each : ui.settings.recent)
        if (!isExample(each)) return fs::path(each).parent_path();
    const char* home = std::getenv("HOME");
    return home ? home : ".";
}

/// Returns the problem; empty on success.
std::string save(Ui& ui, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    const Session& session = ui.session;
    const Result<std::string> text = textToSave(ui);
    Diagnostics problems = text.diagnostics;
    std::vector<CopiedFile> files;
    if (isExample(target)) {
        problems.push_back(
            diagnose("view-E03", "the folder of the examples is not written to; choose another one"));
    } else if (text) {
        files = filesOfCopy(session.live(), target, isExample(session.path()),
                            session.renderOptions().libraryRoots);
        problems = writeCopy(*text, target, files);
        if (problems.empty()) problems = copyExercise(session.path(), target);
    }
    if (!problems.empty()) return problems.front().text;
    ui.notice = fmt::format("saved {}", target.string());
    if (!files.empty())
        ui.notice.text +=
            fmt::format(" and {} file{} that it reads", files.size(), files.size() == 1 ? "" : "s");
    ui.requests.open = target;
    ui.requests.inNewTab = true;
    return {};
}

/// Makes a scene from a template, which is an example, and opens it. Returns the problem; empty on success.
std::string copyTemplate(Ui& ui, const fs::path& from, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    Session session(ui.context, ui.session.renderOptions());
    const auto bytes = image::readFile(from, {from.string(), {}});
    if (!bytes || !session.open(from)) return "cannot read " + from.string();
    const std::vector<CopiedFile> files =
        filesOfCopy(session.live(), target, true, session.renderOptions().libraryRoots);
    const Diagnostics problems =
        writeCopy({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, target, files);
    if (!problems.empty()) return problems.front().text;
    ui.notice = fmt::format("made {}", target.string());
    ui.requests.open = target;
    ui.requests.inNewTab = true;
    return {};
}

/// The templates are the scenes in the folder "start" of the examples.
void newMenu(Ui& ui) {
    std::optional<std::vector<ExampleScene>>& templates = ui.shared.examples.templates;
    if (!templates) {
        const fs::path root = exampleRoot({}, {}, programFile());
        templates = root.empty() ? std::vector<ExampleScene>() : exampleScenes(root);
        std::erase_if(*templates, [](const ExampleScene& each) { return each.topic != "start"; });
    }
    for (const ExampleScene& each : *templates) {
        const std::string label = each.summary.substr(0, each.summary.find(':'));
        if (ImGui::MenuItem((label + "##" + each.name).c_str()))
            ui.shared.dialog.ask({.kind = FileQuestion::Kind::save,
                                  .title = "A new scene like " + each.name,
                                  .button = "Save",
                                  .hint = "The scene and its shaders are written into this folder.",
                                  .endings = ".glib",
                                  .entry = each.name + ".glib",
                                  .chosen =
                                      [from = each.file](Ui& chosenIn, const fs::path& target) {
                                          return copyTemplate(chosenIn, from, target);
                                      }},
                                 ownFolder(ui));
        mark(ui, "file/new/" + each.name);
        if (ImGui::IsItemHovered() && !each.summary.empty()) {
            ImGui::BeginTooltip();
            ImGui::PushTextWrapPos(320 * ui.scale);
            ImGui::TextUnformatted(each.summary.c_str());
            ImGui::PopTextWrapPos();
            ImGui::EndTooltip();
        }
    }
    if (templates->empty()) ImGui::TextDisabled("glibra's own scenes were not found");
}

/// A menu item with a name for tests.
bool item(Ui& ui, const char* label, const char* key, const char* name, bool isEnabled = true) {
    const bool isChosen = ImGui::MenuItem(label, key, false, isEnabled);
    mark(ui, name);
    return isChosen;
}

}  // namespace

void saveScene(Ui& ui) {
    if (!ui.session.hasScene()) return;
    if (isExample(ui.session.path())) return saveSceneAs(ui);
    const Diagnostics problems = saveValues(ui.session.path(), ui.session.knobs(), ui.session.chosenFiles());
    if (!problems.empty()) {
        ui.notice = problems.front();
        return;
    }
    ui.notice = "saved the values in " + ui.session.path().filename().string();
    ui.session.forgetChosenFiles();
}

void saveSceneAs(Ui& ui) {
    if (!ui.session.hasScene()) return;
    const bool isCopy = isExample(ui.session.path());
    const std::string name = ui.session.path().filename().string();
    ui.shared.dialog.ask(
        {.kind = FileQuestion::Kind::save,
         .title = (isCopy ? "Save a copy of " : "Save as: ") + name,
         .button = "Save",
         .hint = isCopy ? "Examples stay as they are. The copy gets your values, and the shaders and other "
                          "files of the scene are copied into its folder."
                        : "The scene with its values. Files that it would not find there are copied, too.",
         .endings = ".glib",
         .entry = name,
         .chosen = [](Ui& chosenIn, const fs::path& target) { return save(chosenIn, target); }},
        ownFolder(ui));
}

void fileMenu(Ui& ui) {
    if (ImGui::Button("File")) ImGui::OpenPopup("file menu");
    mark(ui, "file");
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y}, ImGuiCond_Appearing);
    if (!ImGui::BeginPopup("file menu")) return;
    const bool isOpen = ImGui::BeginMenu("New");
    mark(ui, "file/new");
    if (isOpen) {
        newMenu(ui);
        ImGui::EndMenu();
    }
    if (item(ui, "Open...", "Ctrl+O", "file/open")) {
        ui.shared.dialog.isWanted = true;
        ui.shared.dialog.inNewTab = false;
    }
    if (item(ui, "Examples", "X", "file/examples")) ui.shared.examples.isOpen = true;
    ImGui::Separator();
    const bool hasScene = ui.session.hasScene();
    const bool isShipped = hasScene && isExample(ui.session.path());
    const bool hasChanges =
        hasScene && (hasChangedValues(ui.session.knobs()) || !ui.session.chosenFiles().empty());
    if (item(ui, "Save values", nullptr, "file/save", hasChanges && !isShipped)) saveScene(ui);
    if (item(ui, isShipped ? "Save a copy..." : "Save as...", "Ctrl+Shift+S", "file/saveAs", hasScene))
        saveSceneAs(ui);
    ImGui::Separator();
    const fs::path& solution = solutionOfShown(ui);
    if (item(ui, "Compare with the solution", nullptr, "file/solution", hasScene && !solution.empty()))
        compareWith(ui, solution);
    if (item(ui, "Compare with...", nullptr, "file/compare", hasScene)) askCompareWith(ui);
    if (item(ui, "Write a hardcopy", "H", "file/hardcopy", hasScene)) writeHardcopy(ui);
    ImGui::MenuItem("Verbose", nullptr, &ui.shared.isVerbose);
    mark(ui, "file/verbose");
    if (item(ui, "Noise functions", "N", "file/noise")) ui.shared.noise.isOpen = true;
    ImGui::Separator();
    if (item(ui, "Quit", "Ctrl+Q", "file/quit")) ui.requests.close = true;
    ImGui::EndPopup();
}

}  // namespace glibra::view
