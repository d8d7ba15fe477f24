#include "view/window/panels/shortcuts.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "glib/text.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

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

/// True if the space bar activates the stop that has the keyboard.
bool takesSpace(const Ui& ui) {
    const auto now = stopOf(ui.sliders.drawn, ui.sliders.focused);
    return now != ui.sliders.drawn.end() && !now->isValue && !isUsedByScene(ui, "space");
}

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

// The section with the keys that the scene declares, as buttons.

void keysPanel(Ui& ui) {
    const std::vector<scene::KeyBinding> keys = sceneKeys(ui);
    if (keys.empty() || !section(ui, "Keys of the scene", "keys", true)) return;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(keys[i].key.c_str())) ui.session.pressKey(keys[i].key);
        mark(ui, "key/{}", keys[i].key);
        if (keys[i].isHeld && ImGui::IsItemActive()) holdKey(ui, keys[i].key);
        ImGui::PopID();
        ImGui::SameLine();
        ImGui::TextUnformatted(effectOf(keys[i]).c_str());
        for (const PanelRow* row : panelRows())
            for (const Shortcut& each : row->keys)
                if (glib::sameWord(takenKey(ui, each), keys[i].key))
                    wrappedText(palette().dim, fmt::format("Shift+{}: {}", each.keys, each.what).c_str());
    }
}

// The keys that belong to no panel: tabs, undo, zoom, Esc.

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

const PanelRow kSceneKeysRow{.name = "keys", .place = PanelPlace::section, .make = make<Drawn<keysPanel>>};

const PanelRow kWindowKeysRow{.name = "windowKeys",
                              .place = PanelPlace::floating,
                              .make = make<Panel>,
                              .isShared = true,
                              .keys = kWindowKeys};

}  // namespace glibra::view
