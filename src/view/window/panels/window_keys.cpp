// The keys that belong to no panel: tabs, undo, zoom, Esc.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

template <int step>
void goToTab(Ui& ui, Panel& /*panel*/) {
    const auto count = static_cast<int>(ui.shared.tabs.size());
    if (count > 1)
        ui.requests.showTab =
            static_cast<std::size_t>((static_cast<int>(ui.shared.shownTab) + step + count) % count);
}

void zoom(Ui& ui, float by) {
    ui.settings.zoom = std::clamp(ui.settings.zoom * by, kLeastZoom, kMostZoom);
}

bool closePopup() {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
    return open > 0;
}

/// Closes the tool window in front.
bool closeToolWindow(const Ui& ui) {
    const ImVector<ImGuiWindow*>& order = ImGui::GetCurrentContext()->WindowsFocusOrder;
    for (int i = order.Size - 1; i >= 0; --i)
        for (const PanelUse& each : ui.panels) {
            if (!each.row->title || !each.panel->isOpen || !order[i]->WasActive ||
                std::string_view(order[i]->Name) != each.row->title)
                continue;
            each.panel->isOpen = false;
            return true;
        }
    return false;
}

bool close(Ui& ui, Closing what) {
    return std::ranges::any_of(ui.panels, [&](const PanelUse& each) { return each.panel->close(ui, what); });
}

/// Closes what is in front: a popup, a list of words or the reference, a tool window, the search bar. Without
/// any of them it deselects the picked object. A text field takes Esc for itself, unless it is one that
/// searches. Returns true if something was closed.
bool closeFront(Ui& ui) {
    if (closePopup() || close(ui, Closing::list)) return true;
    const ImGuiWindow* focused = ImGui::GetCurrentContext()->NavWindow;
    const std::string_view owner = focused ? focused->RootWindow->Name : "";
    const bool isTyping = ImGui::GetIO().WantTextInput;
    if (isTyping && owner.starts_with("Source") && close(ui, Closing::bar)) return true;
    if (isTyping && !owner.starts_with("Source") && owner != "Example scenes" &&
        owner != kCommandPaletteRow.title)
        return false;
    if (closeToolWindow(ui) || close(ui, Closing::bar)) return true;
    ui.session.clearPick();
    return std::exchange(ui.sliders.focused, 0) != 0;
}

void escape(Ui& ui, Panel& /*panel*/) {
    if (closeFront(ui)) ui.wanted.keyboardForText = true;
}

/// Undoes a change of values or view. Text fields have their own undo.
void undo(Ui& ui, bool again) {
    if (ImGui::GetIO().WantTextInput) return;
    if (again)
        ui.history.redo(ui.session);
    else
        ui.history.undo(ui.session);
}

constexpr auto kWindowKeys = std::to_array<Shortcut>({
    {KeyGroup::values, GLFW_KEY_Z, true, "Ctrl+Z",
     "undo a change of values or view, or an edit of the source",
     [](Ui& ui, Panel&) { undo(ui, ImGui::GetIO().KeyShift); }, true},
    {KeyGroup::values, GLFW_KEY_Y, true, "Ctrl+Y", "redo", [](Ui& ui, Panel&) { undo(ui, true); }, true},
    {KeyGroup::scenes, GLFW_KEY_F5, false, "F5", "reload the scene",
     [](Ui& ui, Panel&) {
         ui.session.drawLonger();
         ui.requests.reload = true;
     },
     true},
    {KeyGroup::scenes, GLFW_KEY_W, true, "Ctrl+W", "close the tab",
     [](Ui& ui, Panel&) { ui.requests.closeTab = ui.shared.shownTab; }, true},
    {KeyGroup::scenes, GLFW_KEY_PAGE_DOWN, true, "Ctrl+PgDn", "next tab", goToTab<1>, true},
    {KeyGroup::scenes, GLFW_KEY_PAGE_UP, true, "Ctrl+PgUp", "previous tab", goToTab<-1>, true},
    {KeyGroup::window, GLFW_KEY_F11, false, "F11, Shift+F11",
     "full screen, and back; lecture: full screen, large texts, the source over the picture, no panel",
     [](Ui& ui, Panel&) { (ImGui::GetIO().KeyShift ? ui.requests.lecture : ui.requests.fullScreen) = true; },
     true},
    {KeyGroup::window, GLFW_KEY_B, true, "Ctrl+B", "show or hide the panel",
     [](Ui& ui, Panel&) { ui.shared.showPanel = !ui.shared.showPanel; }, true},
    {KeyGroup::window, GLFW_KEY_EQUAL, true, "Ctrl+=", "larger texts and widgets",
     [](Ui& ui, Panel&) { zoom(ui, 1.1F); }, true},
    {KeyGroup::window, GLFW_KEY_MINUS, true, "Ctrl+-", "smaller texts and widgets",
     [](Ui& ui, Panel&) { zoom(ui, 1 / 1.1F); }, true},
    {KeyGroup::window, GLFW_KEY_0, true, "Ctrl+0", "texts and widgets as the screen says",
     [](Ui& ui, Panel&) { ui.settings.zoom = 1; }, true},
    {KeyGroup::window, GLFW_KEY_T, false, "T", "light or dark theme",
     [](Ui& ui, Panel&) { ui.settings.lightTheme = !ui.settings.lightTheme; }},
    {KeyGroup::window, GLFW_KEY_ESCAPE, false, "Esc",
     "close what is in front: menu, list, tool window, search bar; then deselect", escape, true},
    {KeyGroup::window, GLFW_KEY_Q, true, "Ctrl+Q", "quit", [](Ui& ui, Panel&) { ui.requests.close = true; },
     true},
});

}  // namespace

const PanelRow kWindowKeysRow{.name = "windowKeys",
                              .place = PanelPlace::floating,
                              .make = make<Panel>,
                              .isShared = true,
                              .keys = kWindowKeys};

}  // namespace glibra::view
