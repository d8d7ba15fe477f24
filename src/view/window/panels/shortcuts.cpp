#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
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

/// Changes the time of a scene that uses it.
template <class Change>
void changeClock(Ui& ui, const Change& change) {
    if (!ui.session.usesTime()) return;
    Clock clock = ui.session.clock();
    change(clock);
    ui.session.setClock(clock);
}

void stepFrames(Ui& ui, int frames) {
    changeClock(ui, [&](Clock& clock) { clock.step(frames); });
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

void zoom(Ui& ui, float by) {
    ui.settings.zoom = std::clamp(ui.settings.zoom * by, kLeastZoom, kMostZoom);
}

bool closePopup() {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
    return open > 0;
}

struct ToolWindow {
    const char* title;
    bool* isOpen;
};

/// Closes the tool window in front.
bool closeToolWindow(Ui& ui) {
    const auto windows = std::to_array<ToolWindow>({{"Keys and mouse", &ui.showHelp},
                                                    {"Example scenes", &ui.shared.examples.isOpen},
                                                    {"Textures, targets, buffers", &ui.inspector.isOpen},
                                                    {"Noise", &ui.shared.noise.isOpen},
                                                    {kProbeWindow, &ui.probe.isOn},
                                                    {"Verbose", &ui.shared.isVerbose}});
    const ImVector<ImGuiWindow*>& order = ImGui::GetCurrentContext()->WindowsFocusOrder;
    for (int i = order.Size - 1; i >= 0; --i)
        for (const ToolWindow& each : windows) {
            if (!*each.isOpen || !order[i]->WasActive || std::string_view(order[i]->Name) != each.title)
                continue;
            *each.isOpen = false;
            return true;
        }
    return false;
}

/// Closes what is in front: a popup, a list of words or the reference, a tool window, the search bar. Without
/// any of them it deselects the picked object. A text field takes Esc for itself, unless it is one that
/// searches. Returns true if something was closed.
bool closeFront(Ui& ui) {
    if (closePopup() || closeAssist(ui)) return true;
    const ImGuiWindow* focused = ImGui::GetCurrentContext()->NavWindow;
    const std::string_view owner = focused ? focused->RootWindow->Name : "";
    const bool isTyping = ImGui::GetIO().WantTextInput;
    if (isTyping && owner.starts_with("Source") && closeFind(ui)) return true;
    if (isTyping && !owner.starts_with("Source") && owner != "Example scenes") return false;
    if (closeToolWindow(ui) || closeFind(ui)) return true;
    ui.session.clearPick();
    return false;
}

void escape(Ui& ui) {
    if (closeFront(ui)) returnToText(ui);
}

void showNextDebugView(Ui& ui) {
    nextDebugView(ui);
    ui.notice = "Show: " + std::string(nameOf(ui.session.debugView()));
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
void nextProjection(Ui& ui) {
    if (!ui.session.camera().empty()) {
        ui.session.setCamera("");
        ui.session.setTransform(TransformMode::eye, kIdentity);
        return;
    }
    ui.session.nextProjection();
}

/// A row that begins a group of the list of keys.
constexpr Shortcut groupRow(const char* name) {
    return {0, false, "", name, nullptr};
}

const auto kShortcuts = std::to_array<Shortcut>({
    groupRow("Time"),
    {GLFW_KEY_SPACE, false, "Space", "play or pause",
     [](Ui& ui) { changeClock(ui, [](Clock& clock) { clock.play(!clock.isPlaying()); }); }},
    {GLFW_KEY_PERIOD, false, ".", "next frame", [](Ui& ui) { stepFrames(ui, 1); }},
    {GLFW_KEY_COMMA, false, ",", "previous frame", [](Ui& ui) { stepFrames(ui, -1); }},
    {GLFW_KEY_B, false, "B", "pause, and go to the next step", [](Ui& ui) { ui.session.nextStep(); }},
    groupRow("View"),
    {GLFW_KEY_1, false, "1", "the mouse moves the scene", [](Ui& ui) { ui.mode = TransformMode::scene; }},
    {GLFW_KEY_2, false, "2", "the mouse moves the eye", [](Ui& ui) { ui.mode = TransformMode::eye; }},
    {GLFW_KEY_3, false, "3", "the mouse moves the picked object",
     [](Ui& ui) { ui.mode = TransformMode::object; }},
    {GLFW_KEY_4, false, "4", "the mouse moves texture coordinates",
     [](Ui& ui) { ui.mode = TransformMode::texture; }},
    {GLFW_KEY_R, false, "R", "reset all transforms, keep the values",
     [](Ui& ui) { ui.session.resetTransforms(); }},
    {GLFW_KEY_C, false, "C", "look through the scene's next camera", [](Ui& ui) { ui.session.nextCamera(); }},
    {GLFW_KEY_P, false, "P",
     "orthographic or perspective, then as in the scene; first back to its own camera", nextProjection},
    {GLFW_KEY_A, false, "A", "show axes", [](Ui& ui) { ui.session.setAxes(!ui.session.axes()); }},
    {GLFW_KEY_W, false, "W", "show wireframe",
     [](Ui& ui) { ui.session.setWireframe(!ui.session.wireframe()); }},
    groupRow("Values"),
    {GLFW_KEY_R, true, "Ctrl+R", "reset all values", [](Ui& ui) { ui.session.resetValues(); }},
    {GLFW_KEY_L, false, "L", "show values over the picture", [](Ui& ui) { ui.showLabels = !ui.showLabels; }},
    {GLFW_KEY_H, false, "H", "write a hardcopy, to the next free name", writeHardcopy},
    {GLFW_KEY_Z, true, "Ctrl+Z", "undo a change of values or view, or an edit of the source",
     [](Ui& ui) { undo(ui, ImGui::GetIO().KeyShift); }, true},
    {GLFW_KEY_Y, true, "Ctrl+Y", "redo", [](Ui& ui) { undo(ui, true); }, true},
    groupRow("Look into the pipeline"),
    {GLFW_KEY_V, false, "V", "show normals, facing, overdraw, depth ... in place of the picture",
     showNextDebugView},
    {GLFW_KEY_I, false, "I", "show textures, targets and buffers",
     [](Ui& ui) { ui.inspector.isOpen = !ui.inspector.isOpen; }},
    {GLFW_KEY_F, false, "F", "show on the picture how long its objects take",
     [](Ui& ui) { ui.session.setMeasuresObjects(!ui.session.measuresObjects()); }},
    {GLFW_KEY_D, false, "D", "probe: click a pixel to see its inputs, outputs and uniforms", toggleProbe},
    {GLFW_KEY_N, false, "N", "show noise functions",
     [](Ui& ui) { ui.shared.noise.isOpen = !ui.shared.noise.isOpen; }},
    groupRow("Source"),
    {GLFW_KEY_E, false, "E", "show the source: the scene and its shaders",
     [](Ui& ui) { ui.settings.showSource = !ui.settings.showSource; }},
    {GLFW_KEY_E, true, "Ctrl+E", "the same, also while editing text",
     [](Ui& ui) { ui.settings.showSource = !ui.settings.showSource; }, true},
    {GLFW_KEY_S, true, "Ctrl+S, Ctrl+Shift+S", "save the shown source file; save the scene as another file",
     [](Ui& ui) { ImGui::GetIO().KeyShift ? saveSceneAs(ui) : saveSource(ui); }, true},
    {GLFW_KEY_SPACE, true, "Ctrl+Space", "words that may stand at the cursor", completeWord, true},
    {GLFW_KEY_SLASH, true, "Ctrl+/", "make the selected lines comments, or code again", commentLines, true},
    {GLFW_KEY_F1, false, "F1", "the reference: the word at the cursor", showReference, true},
    {GLFW_KEY_F, true, "Ctrl+F", "find in the source", [](Ui& ui) { openFind(ui, false); }, true},
    {GLFW_KEY_H, true, "Ctrl+H", "find and replace", [](Ui& ui) { openFind(ui, true); }, true},
    {GLFW_KEY_F3, false, "F3, Shift+F3", "next match, previous match",
     [](Ui& ui) { findAgain(ui, ImGui::GetIO().KeyShift); }, true},
    {GLFW_KEY_G, true, "Ctrl+G", "go to a line of the source", askLine, true},
    groupRow("Scenes and tabs"),
    {GLFW_KEY_O, true, "Ctrl+O", "open a scene", [](Ui& ui) { openDialog(ui, false); }, true},
    {GLFW_KEY_T, true, "Ctrl+T", "open a scene in a new tab", [](Ui& ui) { openDialog(ui, true); }, true},
    {GLFW_KEY_X, false, "X", "example scenes",
     [](Ui& ui) { ui.shared.examples.isOpen = !ui.shared.examples.isOpen; }},
    {GLFW_KEY_F5, false, "F5", "reload the scene", [](Ui& ui) { ui.requests.reload = true; }, true},
    {GLFW_KEY_W, true, "Ctrl+W", "close the tab", [](Ui& ui) { ui.requests.closeTab = ui.shared.shownTab; },
     true},
    {GLFW_KEY_PAGE_DOWN, true, "Ctrl+PgDn", "next tab", [](Ui& ui) { goToTab(ui, 1); }, true},
    {GLFW_KEY_PAGE_UP, true, "Ctrl+PgUp", "previous tab", [](Ui& ui) { goToTab(ui, -1); }, true},
    groupRow("Window"),
    {GLFW_KEY_B, true, "Ctrl+B", "show or hide the panel", [](Ui& ui) { ui.showPanel = !ui.showPanel; },
     true},
    {GLFW_KEY_EQUAL, true, "Ctrl+=", "larger texts and widgets", [](Ui& ui) { zoom(ui, 1.1F); }, true},
    {GLFW_KEY_MINUS, true, "Ctrl+-", "smaller texts and widgets", [](Ui& ui) { zoom(ui, 1 / 1.1F); }, true},
    {GLFW_KEY_0, true, "Ctrl+0", "texts and widgets as the screen says", [](Ui& ui) { ui.settings.zoom = 1; },
     true},
    {GLFW_KEY_T, false, "T", "light or dark theme",
     [](Ui& ui) { ui.settings.lightTheme = !ui.settings.lightTheme; }},
    {GLFW_KEY_ESCAPE, false, "Esc",
     "close what is in front: menu, list, tool window, search bar; then deselect", escape, true},
    {GLFW_KEY_Q, true, "Ctrl+Q", "quit", [](Ui& ui) { ui.requests.close = true; }, true},
    {GLFW_KEY_SLASH, false, "?", "this list", [](Ui& ui) { ui.showHelp = !ui.showHelp; }},
});

constexpr auto kMouse = std::to_array<std::pair<const char*, const char*>>({
    {"Left drag", "rotate"},
    {"Ctrl+left or middle drag, wheel", "scale"},
    {"Right or Shift+left drag", "pan"},
    {"Click", "pick the object"},
    {"Double click on a slider", "type any value"},
    {"Shift while dragging a slider", "ten times finer"},
    {"Tab, Shift+Tab", "next slider, previous slider"},
    {"Arrows, PgUp, PgDn, Home, End", "move that slider; Enter types a value"},
    {"Right click on a value", "animate, reset or copy it"},
    {"Drop a scene", "open it in a tab"},
    {"Drop a shader or texture", "show it where the scene uses it"},
    {"Drop a folder", "choose one of its scenes"},
});

}  // namespace

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

const std::vector<scene::KeyBinding>& sceneKeys(const Ui& ui) {
    static const std::vector<scene::KeyBinding> kNone;
    return ui.session.hasScene() ? ui.session.live().scene().keys : kNone;
}

/// The scene uses the key of this shortcut, which then needs Shift.
bool isTaken(const Ui& ui, const Shortcut& shortcut) {
    if (shortcut.control || shortcut.whileTyping) return false;
    const std::string name = keyName(shortcut.key);
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
    if (ui.shared.question || ui.messageBox.isShown) return;
    const bool isTyping = ImGui::GetIO().WantTextInput;
    for (const Display::KeyPress& press : pressed) {
        const bool isPlain = !isTyping && !press.control && !press.shift;
        const std::string name = isPlain ? keyName(press.key) : std::string();
        if (!name.empty() && ui.session.pressKey(name)) continue;
        for (const Shortcut& each : kShortcuts)
            if (each.control == press.control && each.key == press.key && (each.whileTyping || !isTyping))
                each.act(ui);
    }
}

void keysPanel(Ui& ui) {
    const std::vector<scene::KeyBinding> keys = sceneKeys(ui);
    if (keys.empty() || !section(ui, "Keys of the scene", "keys", true)) return;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(keys[i].key.c_str())) ui.session.pressKey(keys[i].key);
        mark(ui, "key/{}", keys[i].key);
        ImGui::PopID();
        ImGui::SameLine();
        ImGui::TextUnformatted(effectOf(keys[i]).c_str());
        for (const Shortcut& each : kShortcuts)
            if (isTaken(ui, each) && glib::sameWord(keyName(each.key), keys[i].key)) {
                ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
                ImGui::TextWrapped("Shift+%s: %s", each.keys, each.what);
                ImGui::PopStyleColor();
            }
    }
}

namespace {

/// A group of the list of keys: a heading, and what to press for what.
struct KeyGroup {
    const char* heading;
    std::vector<std::pair<std::string, std::string>> rows;
    std::vector<std::string> marks;  ///< of the first rows, for `--state`

    /// The heading and the space above count as rows.
    [[nodiscard]] std::size_t height() const { return rows.size() + 2; }
};

std::vector<KeyGroup> keyGroups(const Ui& ui) {
    std::vector<KeyGroup> groups;
    if (!sceneKeys(ui).empty()) {
        KeyGroup& own = groups.emplace_back(KeyGroup{"Keys of the scene", {}, {}});
        for (const scene::KeyBinding& each : sceneKeys(ui)) {
            own.rows.emplace_back(each.key, effectOf(each));
            own.marks.push_back("help/key/" + each.key);
        }
    }
    groups.push_back({"Mouse", {kMouse.begin(), kMouse.end()}, {}});
    for (const Shortcut& each : kShortcuts) {
        if (!each.act)
            groups.push_back({each.what, {}, {}});
        else
            groups.back().rows.emplace_back((isTaken(ui, each) ? "Shift+" : "") + std::string(each.keys),
                                            each.what);
    }
    return groups;
}

void keyGroup(Ui& ui, const KeyGroup& group, float keyWidth) {
    ImGui::TextDisabled("%s", group.heading);
    mark(ui, "help/{}", group.heading);
    ImGui::Separator();
    if (!ImGui::BeginTable(group.heading, 2)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keyWidth);
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", group.rows[i].first.c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", group.rows[i].second.c_str());
        if (i < group.marks.size()) mark(ui, group.marks[i]);
    }
    ImGui::EndTable();
    ImGui::Spacing();
}

}  // namespace

void helpWindow(Ui& ui) {
    if (!ui.showHelp) return;
    constexpr float kColumnWidth = 340, kMostColumns = 3;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const std::vector<KeyGroup> groups = keyGroups(ui);
    std::size_t rows = 0;
    for (const KeyGroup& each : groups) rows += each.height();
    const float columns = std::clamp(std::floor(screen.x / (kColumnWidth * ui.scale)), 1.F, kMostColumns);
    const float rowHeight = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    // Some texts take two lines.
    const float height = 1.35F * static_cast<float>(rows) / columns * rowHeight + 3 * ImGui::GetFrameHeight();
    ImGui::SetNextWindowSize(
        {std::min(screen.x, columns * kColumnWidth * ui.scale), std::min(screen.y, height)},
        ImGuiCond_Always);
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {.5F, .5F});
    if (ImGui::Begin(
            "Keys and mouse", &ui.showHelp,
            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        const ImVec2 at = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        ui.widgets["helpWindow"] = {at.x, at.y, size.x, size.y};
        if (ImGui::BeginTable("columns", static_cast<int>(columns))) {
            const float keyWidth = ImGui::CalcTextSize("Ctrl+left or middle drag, wheel ").x;
            const auto perColumn =
                (rows + static_cast<std::size_t>(columns) - 1) / static_cast<std::size_t>(columns);
            std::size_t inColumn = perColumn;  // the first group begins the first column
            for (const KeyGroup& each : groups) {
                if (inColumn + each.height() / 2 >= perColumn) {
                    ImGui::TableNextColumn();
                    inColumn = 0;
                }
                keyGroup(ui, each, keyWidth);
                inColumn += each.height();
            }
            ImGui::EndTable();
        }
    }
    ImGui::End();
}

}  // namespace glibra::view
