#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "glib/text.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

struct Shortcut {
    int key;
    bool control;
    const char* keys;
    const char* what;
    void (*act)(Ui&);
    bool whileTyping = false;  ///< works also while text is entered
};

void step(Ui& ui, int frames) {
    Clock clock = ui.session.clock();
    clock.step(frames);
    ui.session.setClock(clock);
}

void openDialog(Ui& ui, bool inNewTab) {
    ui.shared.dialog.isWanted = true;
    ui.shared.dialog.inNewTab = inNewTab;
}

void goToTab(Ui& ui, int step) {
    const auto count = static_cast<int>(ui.shared.tabs.size());
    if (count > 1)
        ui.requests.showTab =
            static_cast<std::size_t>((static_cast<int>(ui.shared.shownTab) + step + count) % count);
}

void escape(Ui& ui) {
    if (!closeFind(ui) && !ImGui::GetIO().WantTextInput) ui.session.clearPick();
}

/// Ctrl+Z undoes an edit while the source panel has the keyboard. Other text fields have their own undo.
void undo(Ui& ui, bool again) {
    if (ui.sourceState.isActive) return undoTyping(ui, again);
    if (ImGui::GetIO().WantTextInput) return;
    if (again)
        ui.history.redo(ui.session);
    else
        ui.history.undo(ui.session);
}

/// Back to the scene's own camera, if the user looks through another one.
void toggleProjection(Ui& ui) {
    if (!ui.session.camera().empty()) {
        ui.session.setCamera("");
        ui.session.setTransform(TransformMode::eye, kIdentity);
        return;
    }
    ViewState view = ui.session.view();
    view.projection = view.projection == ProjectionMode::orthographic ? ProjectionMode::perspective
                                                                      : ProjectionMode::orthographic;
    ui.session.setView(std::move(view));
}

const auto kShortcuts = std::to_array<Shortcut>({
    {GLFW_KEY_SPACE, false, "Space", "play or pause",
     [](Ui& ui) {
         Clock clock = ui.session.clock();
         clock.play(!clock.isPlaying());
         ui.session.setClock(clock);
     }},
    {GLFW_KEY_PERIOD, false, ".", "next frame", [](Ui& ui) { step(ui, 1); }},
    {GLFW_KEY_COMMA, false, ",", "previous frame", [](Ui& ui) { step(ui, -1); }},
    {GLFW_KEY_1, false, "1", "the mouse moves the scene", [](Ui& ui) { ui.mode = TransformMode::scene; }},
    {GLFW_KEY_2, false, "2", "the mouse moves the eye", [](Ui& ui) { ui.mode = TransformMode::eye; }},
    {GLFW_KEY_3, false, "3", "the mouse moves the picked object",
     [](Ui& ui) { ui.mode = TransformMode::object; }},
    {GLFW_KEY_4, false, "4", "the mouse moves texture coordinates",
     [](Ui& ui) { ui.mode = TransformMode::texture; }},
    {GLFW_KEY_R, false, "R", "reset all transforms, keep the values",
     [](Ui& ui) { ui.session.resetTransforms(); }},
    {GLFW_KEY_R, true, "Ctrl+R", "reset all values", [](Ui& ui) { ui.session.resetValues(); }},
    {GLFW_KEY_B, false, "B", "pause, and go to the next step", [](Ui& ui) { ui.session.nextStep(); }},
    {GLFW_KEY_C, false, "C", "look through the scene's next camera", [](Ui& ui) { ui.session.nextCamera(); }},
    {GLFW_KEY_P, false, "P", "orthographic or perspective projection; first back to the scene's own camera",
     toggleProjection},
    {GLFW_KEY_A, false, "A", "show axes", [](Ui& ui) { ui.session.setAxes(!ui.session.axes()); }},
    {GLFW_KEY_W, false, "W", "show wireframe",
     [](Ui& ui) { ui.session.setWireframe(!ui.session.wireframe()); }},
    {GLFW_KEY_V, false, "V", "show normals, facing, overdraw, depth ... in place of the picture",
     nextDebugView},
    {GLFW_KEY_L, false, "L", "show values over the picture", [](Ui& ui) { ui.showLabels = !ui.showLabels; }},
    {GLFW_KEY_T, false, "T", "light or dark theme",
     [](Ui& ui) { ui.settings.lightTheme = !ui.settings.lightTheme; }},
    {GLFW_KEY_TAB, false, "Tab", "show or hide the panel", [](Ui& ui) { ui.showPanel = !ui.showPanel; }},
    {GLFW_KEY_ESCAPE, false, "Esc", "close the search bar, or deselect the picked object", escape, true},
    {GLFW_KEY_F5, false, "F5", "reload the scene", [](Ui& ui) { ui.requests.reload = true; }, true},
    {GLFW_KEY_E, false, "E", "show the source: the scene and its shaders",
     [](Ui& ui) { ui.settings.showSource = !ui.settings.showSource; }},
    {GLFW_KEY_E, true, "Ctrl+E", "the same, also while editing text",
     [](Ui& ui) { ui.settings.showSource = !ui.settings.showSource; }, true},
    {GLFW_KEY_S, true, "Ctrl+S", "save the shown source file", saveSource, true},
    {GLFW_KEY_X, false, "X", "example scenes",
     [](Ui& ui) { ui.shared.examples.isOpen = !ui.shared.examples.isOpen; }},
    {GLFW_KEY_F, true, "Ctrl+F", "find in the source", [](Ui& ui) { openFind(ui, false); }, true},
    {GLFW_KEY_H, true, "Ctrl+H", "find and replace", [](Ui& ui) { openFind(ui, true); }, true},
    {GLFW_KEY_F3, false, "F3, Shift+F3", "next match, previous match",
     [](Ui& ui) { findAgain(ui, ImGui::GetIO().KeyShift); }, true},
    {GLFW_KEY_G, true, "Ctrl+G", "go to a line of the source", askLine, true},
    {GLFW_KEY_Z, true, "Ctrl+Z", "undo a change of values or view, or an edit of the source",
     [](Ui& ui) { undo(ui, ImGui::GetIO().KeyShift); }, true},
    {GLFW_KEY_Y, true, "Ctrl+Y", "redo", [](Ui& ui) { undo(ui, true); }, true},
    {GLFW_KEY_O, true, "Ctrl+O", "open a scene", [](Ui& ui) { openDialog(ui, false); }, true},
    {GLFW_KEY_T, true, "Ctrl+T", "open a scene in a new tab", [](Ui& ui) { openDialog(ui, true); }, true},
    {GLFW_KEY_W, true, "Ctrl+W", "close the tab", [](Ui& ui) { ui.requests.closeTab = ui.shared.shownTab; },
     true},
    {GLFW_KEY_PAGE_DOWN, true, "Ctrl+PgDn", "next tab", [](Ui& ui) { goToTab(ui, 1); }, true},
    {GLFW_KEY_PAGE_UP, true, "Ctrl+PgUp", "previous tab", [](Ui& ui) { goToTab(ui, -1); }, true},
    {GLFW_KEY_I, false, "I", "show textures, targets and buffers",
     [](Ui& ui) { ui.inspector.isOpen = !ui.inspector.isOpen; }},
    {GLFW_KEY_N, false, "N", "show noise functions",
     [](Ui& ui) { ui.shared.noise.isOpen = !ui.shared.noise.isOpen; }},
    {GLFW_KEY_Q, true, "Ctrl+Q", "quit", [](Ui& ui) { ui.requests.close = true; }, true},
    {GLFW_KEY_SLASH, false, "?", "this list", [](Ui& ui) { ui.showHelp = !ui.showHelp; }},
});

constexpr auto kMouse = std::to_array<std::pair<const char*, const char*>>({
    {"Left drag", "rotate"},
    {"Middle drag, wheel", "scale"},
    {"Right or Shift+left drag", "pan"},
    {"Click", "pick the object"},
    {"Double click on a slider", "type any value"},
    {"Right click on a name", "reset or copy the value"},
    {"Drop a scene", "open it in a tab"},
    {"Drop a shader or texture", "show it where the scene uses it"},
    {"Drop a folder", "choose one of its scenes"},
});

}  // namespace

namespace {

/// The key as Key statements name it; empty if they cannot.
std::string nameOf(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return {static_cast<char>('a' + key - GLFW_KEY_A)};
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return {static_cast<char>('0' + key - GLFW_KEY_0)};
    constexpr std::pair<int, const char*> kNames[] = {{GLFW_KEY_SPACE, "space"}, {GLFW_KEY_ENTER, "enter"},
                                                      {GLFW_KEY_LEFT, "left"},   {GLFW_KEY_RIGHT, "right"},
                                                      {GLFW_KEY_UP, "up"},       {GLFW_KEY_DOWN, "down"}};
    for (const auto& [known, name] : kNames)
        if (known == key) return name;
    return {};
}

const std::vector<scene::KeyBinding>& sceneKeys(const Ui& ui) {
    static const std::vector<scene::KeyBinding> kNone;
    return ui.session.hasScene() ? ui.session.live().scene().keys : kNone;
}

/// The scene uses the key of this shortcut, which then needs Shift.
bool isTaken(const Ui& ui, const Shortcut& shortcut) {
    if (shortcut.control || shortcut.whileTyping) return false;
    const std::string name = nameOf(shortcut.key);
    return std::any_of(sceneKeys(ui).begin(), sceneKeys(ui).end(),
                       [&](const scene::KeyBinding& each) { return glib::sameWord(each.key, name); });
}

std::string effectOf(const scene::KeyBinding& key) {
    if (key.restarts) return "begin the scene anew";
    return (key.values.size() > 1 ? "next value of " : "set ") + key.variable;
}

}  // namespace

void shortcuts(Ui& ui) {
    const std::vector<Display::KeyPress> pressed = std::exchange(ui.pressed, {});
    if (ui.shared.question) return;
    const bool isTyping = ImGui::GetIO().WantTextInput;
    for (const Display::KeyPress& press : pressed) {
        const bool isPlain = !isTyping && !press.control && !ImGui::GetIO().KeyShift;
        const std::string name = isPlain ? nameOf(press.key) : std::string();
        if (!name.empty() && ui.session.pressKey(name)) continue;
        for (const Shortcut& each : kShortcuts)
            if (each.control == press.control && each.key == press.key && (each.whileTyping || !isTyping))
                each.act(ui);
    }
}

void keysPanel(Ui& ui) {
    const std::vector<scene::KeyBinding> keys = sceneKeys(ui);
    if (keys.empty() || !ImGui::CollapsingHeader("Keys of the scene", ImGuiTreeNodeFlags_DefaultOpen)) return;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(keys[i].key.c_str())) ui.session.pressKey(keys[i].key);
        mark(ui, "key/{}", keys[i].key);
        ImGui::PopID();
        ImGui::SameLine();
        ImGui::TextUnformatted(effectOf(keys[i]).c_str());
        for (const Shortcut& each : kShortcuts)
            if (isTaken(ui, each) && glib::sameWord(nameOf(each.key), keys[i].key)) {
                ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
                ImGui::TextWrapped("Shift+%s: %s", each.keys, each.what);
                ImGui::PopStyleColor();
            }
    }
}

void helpWindow(Ui& ui) {
    if (!ui.showHelp) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const auto rows = static_cast<float>(kMouse.size() + kShortcuts.size() + sceneKeys(ui).size() + 2);
    const float height = rows * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y) +
                         2 * ImGui::GetFrameHeight();
    // Two columns of keys if one would be too high and the window is wide enough.
    const bool isWide = height > screen.y && screen.x > 780 * ui.scale;
    ImGui::SetNextWindowSize({std::min(screen.x, (isWide ? 980 : 520) * ui.scale),
                              std::min(screen.y, isWide ? height * .62F : height)},
                             ImGuiCond_Always);
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {.5F, .5F});
    if (ImGui::Begin(
            "Keys and mouse", &ui.showHelp,
            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        const ImVec2 at = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        ui.widgets["helpWindow"] = {at.x, at.y, size.x, size.y};
        if (ImGui::BeginTable("keys", isWide ? 4 : 2)) {
            const float keys = ImGui::CalcTextSize("Drop a shader or texture ").x;
            for (int i = 0; i < (isWide ? 2 : 1); ++i) {
                ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keys);
                ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
            }
            const auto row = [](const std::string& first, const char* second) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(first.c_str());
                ImGui::TableNextColumn();
                ImGui::TextWrapped("%s", second);
            };
            for (const scene::KeyBinding& each : sceneKeys(ui)) {
                row(each.key + " (scene)", effectOf(each).c_str());
                mark(ui, "help/key/{}", each.key);
            }
            for (const auto& [doing, what] : kMouse) row(doing, what);
            for (const Shortcut& each : kShortcuts)
                row(isTaken(ui, each) ? std::string("Shift+") + each.keys : each.keys, each.what);
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

}  // namespace glibra::view
