// The buttons at the top of the panel.

#include <imgui.h>

#include <array>

#include "view/window/panels/icons.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

void scenePanel(Ui& ui) {
    constexpr std::array kTools{"Open...", "Examples", "Source"};
    fileMenu(ui);
    // Words become icons before a button would stand alone in a second row.
    const float space = ImGui::GetStyle().ItemSpacing.x;
    const float others = ImGui::GetItemRectSize().x + 2 * ImGui::GetFrameHeight() + 3 * space;
    const std::size_t shorts = shortTools(kTools, ImGui::GetContentRegionAvail().x - others);
    continueRowForTool(kTools[0], shorts > 0);
    if (toolButton(Icon::open, kTools[0], "Open a scene (Ctrl+O)", shorts > 0)) {
        ui.shared.dialog.isWanted = true;
        ui.shared.dialog.inNewTab = false;
    }
    mark(ui, "scene/open");
    continueRowForTool(kTools[1], shorts > 1);
    if (toolButton(Icon::examples, kTools[1], "Example scenes with their pictures (X)", shorts > 1))
        ui.shared.examples.isOpen = !ui.shared.examples.isOpen;
    mark(ui, "scene/examples");
    continueRowForTool(kTools[2], shorts > 2);
    ImGui::BeginDisabled(!ui.session.hasScene());
    if (toolButton(Icon::source, kTools[2], "Edit the scene and its shaders (E)", shorts > 2))
        ui.settings.showSource = !ui.settings.showSource;
    ImGui::EndDisabled();
    mark(ui, "scene/source");
    continueRowForIcon();
    if (iconButton(Icon::reload, "Reload", "Load the scene and its files again (F5)"))
        ui.requests.reload = true;
    mark(ui, "scene/reload");
    continueRowForIcon();
    if (iconButton(Icon::help, "?", "Keys and mouse (?)")) ui.showHelp = !ui.showHelp;
    mark(ui, "help");
}

}  // namespace glibra::view
