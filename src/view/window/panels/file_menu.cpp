#include "view/window/panels/ui.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/own_library.h"
#include "image/file.h"
#include "system/places.h"
#include "view/browse/example_scenes.h"
#include "view/edit/edited_file.h"
#include "view/edit/saved_scene.h"
#include "view/session/comparison.h"
#include "view/window/panels/source_header.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

struct FileMenu {
    std::optional<std::vector<ExampleScene>> templates;  ///< of the menu "New", listed when it is first open
    std::filesystem::path exercise;                      ///< the scene that `solution` was looked up for
    std::filesystem::path solution;                      ///< of the tab's scene; empty: it is no exercise
    bool opens = false;                                  ///< the menu is to open, with the keyboard in it
};

namespace fs = std::filesystem;

void openMade(Ui& ui, const fs::path& scene) {
    ui.notice = "made " + scene.generic_string();
    toolWindow(ui, "examples").isOpen = false;  // it would stand in front of the new scene
    ui.requests.open = scene;
    ui.requests.inNewTab = true;
}

/// Makes a scene from a template, which is an example, and opens it. Returns the problem; empty on success.
std::string copyTemplate(Ui& ui, const fs::path& from, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    if (const Diagnostics problems = writingProblem(target); !problems.empty()) return problems.front().text;
    Session session(ui.context, ui.session.renderOptions());
    const auto bytes = image::readFile(from, {from.generic_string(), {}});
    if (!bytes || !session.open(from)) return "cannot read " + from.generic_string();
    const std::vector<CopiedFile> files =
        filesOfCopy(session.live(), target, true, session.renderOptions().libraryRoots);
    const Diagnostics problems =
        writeCopy({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, target, files);
    if (!problems.empty()) return problems.front().text;
    openMade(ui, target);
    return {};
}

/// A scene to write into. It draws nothing yet, which is no mistake.
constexpr std::string_view kEmptyScene =
    "# A new scene.\n\nPerspective 50\nLookAt 0 0 4  0 0 0  0 1 0\n\n"
    "# Vertex, Fragment and Program, and then what they draw:\n\n";

/// Makes an empty scene and opens it with its source. Returns the problem; empty on success.
std::string makeEmptyScene(Ui& ui, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    Diagnostics problems = writingProblem(target);
    if (problems.empty())
        problems = image::writeFileAtomically(target, std::as_bytes(std::span(kEmptyScene)));
    if (!problems.empty()) return problems.front().text;
    openMade(ui, target);
    ui.settings.showSource = true;
    return {};
}

/// The templates are the scenes in the folder "start" of the examples.
void newMenu(Ui& ui, std::optional<std::vector<ExampleScene>>& templates) {
    if (!templates) {
        const fs::path root = exampleRoot({}, {}, system::programFile());
        templates = root.empty() ? std::vector<ExampleScene>() : exampleScenes(root);
        std::erase_if(*templates, [](const ExampleScene& each) { return each.topic != "start"; });
    }
    if (ImGui::MenuItem("Empty scene")) askEmptyScene(ui);
    mark(ui, "file/new/empty");
    for (const ExampleScene& each : *templates) {
        const std::string label = each.summary.substr(0, each.summary.find(':'));
        if (ImGui::MenuItem((label + "##" + each.name).c_str()))
            askForFile(
                ui,
                {.kind = FileQuestion::Kind::save,
                 .title = "A new scene like " + each.name,
                 .button = "Save",
                 .hint = "The scene and its shaders are written into this folder.",
                 .endings = ".glib",
                 .entry = each.name + ".glib",
                 .chosen = [from = each.file](
                               Ui& in, const fs::path& target) { return copyTemplate(in, from, target); }},
                ownFolder(ui));
        mark(ui, "file/new/" + each.name);
        if (ImGui::IsItemHovered() && !each.summary.empty())
            wrappedTooltip(each.summary.c_str(), 320 * ui.shared.scale);
    }
    if (templates->empty()) ImGui::TextDisabled("glibra's own scenes were not found");
}

/// The solution of the shown scene if an exercise begins with it; otherwise empty.
const fs::path& solutionOfShown(const Ui& ui, FileMenu& menu) {
    if (menu.exercise != ui.session.path()) {
        menu.exercise = ui.session.path();
        menu.solution = solutionOf(menu.exercise);
    }
    return menu.solution;
}

/// A menu item with a name for tests.
bool item(Ui& ui, const char* label, const char* key, const char* name, bool isEnabled = true) {
    const bool isChosen = ImGui::MenuItem(label, key, false, isEnabled);
    mark(ui, name);
    return isChosen;
}

/// Shows the solution of the exercise beside the picture; says so if the scene is no exercise.
void compareWithSolution(Ui& ui) {
    const fs::path solution = ui.session.hasScene() ? solutionOf(ui.session.path()) : fs::path();
    if (solution.empty())
        ui.notice = {"this scene is no exercise: no file beside it names a solution", true};
    else
        ui.wanted.compared = solution;
}

/// Asks for a scene to show beside the picture.
void askCompareWith(Ui& ui) {
    if (!ui.session.hasScene()) return;
    askForFile(ui,
               {.title = "Compare with",
                .button = "Compare",
                .hint = "Its picture is shown beside that of this scene, with the same values.",
                .endings = ".glib",
                .chosen =
                    [](Ui& in, const fs::path& scene) {
                        in.wanted.compared = scene;
                        return std::string();
                    }},
               ui.session.path().parent_path());
}

/// The button "File" and its menu.
void fileMenu(Ui& ui, FileMenu& menu) {
    if (ImGui::Button("File") || menu.opens) ImGui::OpenPopup("file menu");
    mark(ui, "file");
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y}, ImGuiCond_Appearing);
    if (!ImGui::BeginPopup("file menu")) return;
    if (std::exchange(menu.opens, false)) giveKeyboardToNext();
    const bool isOpen = ImGui::BeginMenu("New");
    mark(ui, "file/new");
    if (isOpen) {
        newMenu(ui, menu.templates);
        ImGui::EndMenu();
    }
    if (item(ui, "Open...", "Ctrl+O", "file/open")) openDialog(ui, false);
    if (item(ui, "Reopen closed tab", "Ctrl+Shift+T", "file/reopen")) ui.requests.reopenTab = true;
    if (item(ui, "Examples", "X", "file/examples")) toolWindow(ui, "examples").isOpen = true;
    ImGui::Separator();
    const bool hasScene = ui.session.hasScene();
    const bool isShipped = hasScene && isExample(ui.session.path());
    const bool hasChanges = hasScene && (ui.values.isChanged() || !ui.session.chosenFiles().empty());
    if (item(ui, "Save values", nullptr, "file/save", hasChanges && !isShipped)) saveScene(ui);
    if (item(ui, isShipped ? "Save a copy..." : "Save as...", "Ctrl+Shift+S", "file/saveAs", hasScene))
        saveSceneAs(ui);
    const bool hasTexts =
        std::ranges::any_of(ui.shared.sources, [](const auto& each) { return each.second.isChanged(); });
    if (item(ui, "Save all texts", nullptr, "file/saveAll", hasTexts)) saveAllSources(ui);
    ImGui::Separator();
    const fs::path& solution = solutionOfShown(ui, menu);
    if (item(ui, "Compare with the solution", nullptr, "file/solution", hasScene && !solution.empty()))
        compareWithSolution(ui);
    if (item(ui, "Compare with...", nullptr, "file/compare", hasScene)) askCompareWith(ui);
    if (item(ui, "Write a hardcopy", "H", "file/hardcopy", hasScene)) ui.wanted.hardcopy = true;
    ImGui::MenuItem("Verbose", nullptr, &toolWindow(ui, "verbose").isOpen);
    mark(ui, "file/verbose");
    if (item(ui, "Noise functions", "N", "file/noise")) toolWindow(ui, "noise").isOpen = true;
    ImGui::Separator();
    if (item(ui, "Quit", "Ctrl+Q", "file/quit")) ui.requests.close = true;
    ImGui::EndPopup();
}

// The buttons at the top of the panel.

void scenePanel(Ui& ui, FileMenu& menu) {
    constexpr std::array kTools{"Open...", "Examples", "Source"};
    fileMenu(ui, menu);
    // Words become icons before a button would stand alone in a second row.
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float others = ImGui::GetItemRectSize().x + 2 * ImGui::GetFrameHeight() + 3 * space;
    const std::size_t shorts = shortTools(kTools, ImGui::GetContentRegionAvail().x - others);
    continueRowForTool(kTools[0], shorts > 0);
    if (toolButton(Icon::open, kTools[0], "Open a scene (Ctrl+O)", shorts > 0)) openDialog(ui, false);
    mark(ui, "scene/open");
    continueRowForTool(kTools[1], shorts > 1);
    if (toolButton(Icon::examples, kTools[1], "Example scenes with their pictures (X)", shorts > 1))
        toggleOpen(ui, toolWindow(ui, "examples"));
    mark(ui, "scene/examples");
    continueRowForTool(kTools[2], shorts > 2);
    ImGui::BeginDisabled(!ui.session.hasScene());
    if (toolButton(Icon::source, kTools[2], "Edit the scene and its shaders (E)", shorts > 2))
        ui.settings.showSource = !ui.settings.showSource;
    ImGui::EndDisabled();
    mark(ui, "scene/source");
    continueRowForIcon();
    if (iconButton(Icon::reload, "Reload", "Load the scene and its files again (F5)")) {
        ui.session.drawLonger();
        ui.requests.reload = true;
    }
    mark(ui, "scene/reload");
    continueRowForIcon();
    if (iconButton(Icon::help, "?", "Keys and mouse (?)")) toggleOpen(ui, toolWindow(ui, "help"));
    mark(ui, "help");
}

class Tools final : public Panel {
  public:
    void update(Ui& ui) override { watchAlt(ui); }
    void show(Ui& ui) override { scenePanel(ui, menu_); }
    void openMenu(Ui& ui) {
        if (ImGui::GetIO().KeyShift) return;  // the menu of a value
        ui.shared.showPanel = true;
        menu_.opens = true;
    }

  private:
    /// Alt opens the menu when it goes up, if nothing else was pressed with it.
    void watchAlt(Ui& ui) {
        const ImGuiIO& io = ImGui::GetIO();
        const bool isDown = io.KeyAlt;
        if (isDown && !wasAlt_) isAltAlone_ = true;
        for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST && isDown; ++key) {
            const bool isAlt = key == GLFW_KEY_LEFT_ALT || key == GLFW_KEY_RIGHT_ALT;
            if (!isAlt && isKeyDown(key)) isAltAlone_ = false;
        }
        if (ImGui::IsAnyMouseDown()) isAltAlone_ = false;
        // The desktop takes the window's keys away when it goes to another window by Alt and Tab.
        const bool hasFocus = glfwGetWindowAttrib(glfwGetCurrentContext(), GLFW_FOCUSED) == GLFW_TRUE;
        if (wasAlt_ && !isDown && isAltAlone_ && hasFocus && !ui.shared.question) openMenu(ui);
        wasAlt_ = isDown;
    }

    FileMenu menu_;
    bool wasAlt_ = false, isAltAlone_ = false;
};

void openTab(Ui& ui, Panel& /*panel*/) {
    if (ImGui::GetIO().KeyShift)
        ui.requests.reopenTab = true;
    else
        openDialog(ui, true);
}

constexpr auto kToolKeys = std::to_array<Shortcut>({
    {KeyGroup::scenes, GLFW_KEY_O, true, "Ctrl+O", "open a scene",
     [](Ui& ui, Panel&) { openDialog(ui, false); }, true},
    {KeyGroup::scenes, GLFW_KEY_T, true, "Ctrl+T, Ctrl+Shift+T",
     "open a scene in a new tab; open the tab again that was closed last", openTab, true},
    // Without keys: for the list of commands.
    {KeyGroup::scenes, kNoKey, false, "", "save the values in the scene",
     [](Ui& ui, Panel&) { saveScene(ui); }},
    {KeyGroup::scenes, kNoKey, false, "", "save the scene as another file, or save a copy of an example",
     [](Ui& ui, Panel&) { saveSceneAs(ui); }},
    {KeyGroup::scenes, kNoKey, false, "", "new, empty scene", [](Ui& ui, Panel&) { askEmptyScene(ui); }},
    {KeyGroup::scenes, kNoKey, false, "", "new scene from a template", call<&Tools::openMenu>},
    {KeyGroup::scenes, kNoKey, false, "", "compare with the solution of the exercise",
     [](Ui& ui, Panel&) { compareWithSolution(ui); }},
    {KeyGroup::scenes, kNoKey, false, "", "compare with another scene",
     [](Ui& ui, Panel&) { askCompareWith(ui); }},
    {KeyGroup::window, GLFW_KEY_F10, false, "F10 or Alt", "the menu File", call<&Tools::openMenu>, true},
});

}  // namespace

void askEmptyScene(Ui& ui) {
    askForFile(ui,
               {.kind = FileQuestion::Kind::save,
                .title = "A new, empty scene",
                .button = "Save",
                .hint = "The scene is written into this folder.",
                .endings = ".glib",
                .entry = "scene.glib",
                .chosen = makeEmptyScene},
               ownFolder(ui));
}

const PanelRow kToolsRow{
    .name = "tools", .place = PanelPlace::head, .make = make<Tools>, .isShared = true, .keys = kToolKeys};

}  // namespace glibra::view
