#include "view/window/panels/shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "view/window/panels/tab_stops.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

/// The key as Key statements name it; empty if they cannot.
std::string keyName(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return {static_cast<char>('a' + key - GLFW_KEY_A)};
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return {static_cast<char>('0' + key - GLFW_KEY_0)};
    constexpr std::pair<int, const char*> kNames[] = {{GLFW_KEY_SPACE, "space"}, {GLFW_KEY_ENTER, "enter"},
                                                      {GLFW_KEY_LEFT, "left"},   {GLFW_KEY_RIGHT, "right"},
                                                      {GLFW_KEY_UP, "up"},       {GLFW_KEY_DOWN, "down"}};
    for (const auto& [known, name] : kNames)
        if (known == key) return name;
    return {};
}

/// The keys that a Key statement may name, by their GLFW codes.
constexpr std::pair<int, int> kNamedKeys[] = {{GLFW_KEY_A, GLFW_KEY_Z},
                                              {GLFW_KEY_0, GLFW_KEY_9},
                                              {GLFW_KEY_SPACE, GLFW_KEY_SPACE},
                                              {GLFW_KEY_ENTER, GLFW_KEY_ENTER},
                                              {GLFW_KEY_RIGHT, GLFW_KEY_UP}};

/// Lets the keys of the scene act that are down.
void holdKeys(Ui& ui) {
    const std::vector<scene::KeyBinding>& keys = sceneKeys(ui);
    const auto isHeld = [](const scene::KeyBinding& each) { return each.isHeld; };
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl || io.KeyShift || std::ranges::none_of(keys, isHeld)) return;
    for (const auto& [first, last] : kNamedKeys)
        for (int key = first; key <= last; ++key)
            if (isKeyDown(key)) holdKey(ui, keyName(key));
}

void press(Ui& ui, const Display::KeyPress& key, bool isTyping) {
    for (const PanelUse& panel : ui.panels)
        for (const Shortcut& each : panel.row->keys)
            if (each.control == key.control && each.key == key.key && (each.whileTyping || !isTyping))
                each.act(ui, *panel.panel);
}

}  // namespace

const std::vector<scene::KeyBinding>& sceneKeys(const Ui& ui) {
    static const std::vector<scene::KeyBinding> kNone;
    return ui.session.hasScene() ? ui.session.live().scene().keys : kNone;
}

std::string takenKey(const Ui& ui, const Shortcut& shortcut) {
    if (shortcut.control || shortcut.whileTyping) return {};
    const std::string name = keyName(shortcut.key);
    return isUsedByScene(ui, name) ? name : std::string();
}

std::string effectOf(const scene::KeyBinding& key) {
    if (key.restarts) return "begin the scene anew";
    if (key.isHeld) return "hold to move " + key.variable;
    return (key.values.size() > 1 ? "next value of " : "set ") + key.variable;
}

void holdKey(Ui& ui, const std::string& key) {
    // The time of the first frame after a pause is that of the pause.
    constexpr double kMostSeconds = .1;
    ui.session.holdKey(key, std::min(static_cast<double>(ImGui::GetIO().DeltaTime), kMostSeconds));
    ui.requests.frames = true;
}

void shortcuts(Ui& ui) {
    const std::vector<Display::KeyPress> pressed = std::exchange(ui.frame.pressed, {});
    const bool areBlocked =
        std::ranges::any_of(ui.panels, [](const PanelUse& each) { return each.panel->blocksKeys(); });
    if (ui.shared.question || areBlocked) return;
    const bool isTyping = ImGui::GetIO().WantTextInput;
    if (!isTyping) holdKeys(ui);
    const bool isSpaceTaken = takesSpace(ui);
    for (const Display::KeyPress& each : pressed) {
        if (each.key == GLFW_KEY_SPACE && !each.control && isSpaceTaken) {
            ui.sliders.isSpacePressed = true;
            continue;
        }
        const bool isPlain = !isTyping && !each.control && !each.shift;
        const std::string name = isPlain ? keyName(each.key) : std::string();
        if (name.empty() || !ui.session.pressKey(name)) press(ui, each, isTyping);
    }
}

}  // namespace glibra::view
