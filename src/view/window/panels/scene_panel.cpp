// The buttons at the top of the panel.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>

#include "view/window/panels/file_menu.h"
#include "view/window/panels/icons.h"
#include "view/window/panels/save_scene.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

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

const PanelRow kToolsRow{
    .name = "tools", .place = PanelPlace::head, .make = make<Tools>, .isShared = true, .keys = kToolKeys};

}  // namespace glibra::view
