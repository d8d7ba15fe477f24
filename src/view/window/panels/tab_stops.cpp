#include "view/window/panels/tab_stops.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "glib/text.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

using Stops = std::vector<TabStop>;

Stops::const_iterator stopOf(const Stops& stops, unsigned id) {
    return std::ranges::find_if(stops, [&](const TabStop& each) { return each.id == id; });
}

void addStop(Ui& ui, TabStop stop) {
    if (stopOf(ui.sliders.drawn, stop.id) == ui.sliders.drawn.end()) ui.sliders.drawn.push_back(stop);
    if (ui.sliders.focused != stop.id || stop.isValue) return;
    if (std::exchange(ui.sliders.reveals, false) && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    if (ImGui::GetIO().WantTextInput && stop.isEntry) return;  // it shows its cursor
    const float wide = 2 * ui.shared.scale;
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        ImGui::GetColorU32(ImGuiCol_NavHighlight),
                                        ImGui::GetStyle().FrameRounding, 0, wide);
}

/// Where Tab begins: in the tool window in front, or else at the first value.
Stops::const_iterator firstStop(const Ui& ui, const Stops& stops) {
    const ImGuiWindow* front = ImGui::GetCurrentContext()->NavWindow;
    if (front != nullptr) front = front->RootWindow;
    const bool isTool =
        front != nullptr && std::ranges::any_of(ui.panels, [&](const PanelUse& each) {
            return each.row->title && each.panel->isOpen && std::string_view(front->Name) == each.row->title;
        });
    const auto first = std::ranges::find_if(
        stops, [&](const TabStop& each) { return isTool ? each.window == front->ID : each.isInValues; });
    return first == stops.end() ? stops.begin() : first;
}

Stops::const_iterator nextStop(const Stops& stops, Stops::const_iterator now, bool back) {
    if (back) return now == stops.begin() ? std::prev(stops.end()) : std::prev(now);
    return std::next(now) == stops.end() ? stops.begin() : std::next(now);
}

/// The first stop of the next window.
Stops::const_iterator inNextWindow(const Stops& stops, Stops::const_iterator now) {
    auto next = now;
    do next = nextStop(stops, next, false);
    while (next != now && next->window == now->window);
    return stopOf(stops, next->id);
}

void goToStop(Ui& ui, bool back, bool toNextWindow) {
    const Stops& stops = ui.sliders.drawn;
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    // A text field that has the keyboard counts as focused, however it got it.
    auto now = context.ActiveId != 0 ? stopOf(stops, context.ActiveId) : stops.end();
    if (now == stops.end() && context.ActiveIdWindow != nullptr && ImGui::GetIO().WantTextInput)
        now = std::ranges::find_if(stops, [&](const TabStop& each) {
            return each.window == context.ActiveIdWindow->RootWindow->ID;
        });
    if (now == stops.end()) now = stopOf(stops, ui.sliders.focused);
    if (ImGui::GetIO().WantTextInput) ImGui::ClearActiveID();
    auto next = stops.begin();
    if (now == stops.end())
        next = back ? nextStop(stops, firstStop(ui, stops), true) : firstStop(ui, stops);
    else
        next = toNextWindow ? inNextWindow(stops, now) : nextStop(stops, now, back);
    ui.sliders.focused = next->id;
    ui.sliders.reveals = true;
    ui.requests.frames = true;
    if (next->isEntry) activateItem(next->id, true);
}

}  // namespace

unsigned thisWindow() {
    return ImGui::GetCurrentContext()->CurrentWindow->RootWindow->ID;
}

bool isUsedByScene(const Ui& ui, std::string_view key) {
    if (!ui.session.hasScene()) return false;
    const auto& keys = ui.session.live().scene().keys;
    return std::ranges::any_of(keys,
                               [&](const scene::KeyBinding& each) { return glib::sameWord(each.key, key); });
}

void tabStop(Ui& ui) {
    const ImGuiID id = ImGui::GetItemID();
    if (id == 0 || (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) != 0) return;
    addStop(ui, {id, thisWindow(), false, (ImGui::GetItemFlags() & ImGuiItemFlags_Inputable) != 0});
}

bool tabStop(Ui& ui, unsigned id) {
    addStop(ui, {id, thisWindow(), false, false});
    if (id == 0 || ui.sliders.activated != id) return false;
    ui.sliders.activated = 0;
    return true;
}

void beginStops(Ui& ui) {
    Sliders& sliders = ui.sliders;
    sliders.activated = 0;
    sliders.wantsMenu = false;
    const bool isSpace = std::exchange(sliders.isSpacePressed, false);
    const ImGuiIO& io = ImGui::GetIO();
    const bool isElsewhere = ui.shared.question || !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    if (isElsewhere || io.KeyAlt || io.KeyCtrl || sliders.drawn.empty()) return;
    if (isKeyPressed(GLFW_KEY_TAB) && !ui.shared.textTakesTab) return goToStop(ui, io.KeyShift, false);
    if (isKeyPressed(GLFW_KEY_F6)) return goToStop(ui, false, true);
    const auto now = stopOf(sliders.drawn, sliders.focused);
    if (io.WantTextInput || now == sliders.drawn.end()) return;
    sliders.wantsMenu =
        isKeyPressed(GLFW_KEY_MENU, false) || (io.KeyShift && isKeyPressed(GLFW_KEY_F10, false));
    if (now->isValue) return;
    const bool isEnter = isEnterPressed(false) && !isUsedByScene(ui, "enter");
    if (!isEnter && !isSpace) return;
    sliders.activated = now->id;
    activateItem(now->id, now->isEntry);
    ui.requests.frames = true;
}

bool takesSpace(const Ui& ui) {
    const auto now = stopOf(ui.sliders.drawn, ui.sliders.focused);
    return now != ui.sliders.drawn.end() && !now->isValue && !isUsedByScene(ui, "space");
}

}  // namespace glibra::view
