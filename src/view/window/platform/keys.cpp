#include "view/window/platform/keys.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <iterator>
#include <utility>
#include <vector>

namespace glibra::view {
namespace {

constexpr unsigned kButtons = 3;

/// ImGui keeps in mind that keys made the last active item so, also when it is none any more, and takes the
/// next click for a key: it then marks nothing below the mouse, and a menu in a menu closes below the click.
void tellOfMouse(const FrameInput& input) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (input.buttons != 0 && context.ActiveId == 0) context.ActiveIdSource = ImGuiInputSource_Mouse;
}

void giveText(const std::string& text) {
    for (const char* at = text.c_str(); *at != '\0';) {
        unsigned character = 0;
        at += ImTextCharFromUtf8(&character, at, nullptr);
        ImGui::GetIO().AddInputCharacter(character);
    }
}

}  // namespace

FrameInput inputOf(const InputQueue& queue, const InputQueue::Frame& frame) {
    FrameInput input;
    input.mouseX = frame.mouse ? static_cast<float>(frame.mouse->x) : -FLT_MAX;
    input.mouseY = frame.mouse ? static_cast<float>(frame.mouse->y) : -FLT_MAX;
    input.buttons = frame.buttons;
    input.wheel = static_cast<float>(frame.wheel);
    for (int key = 0; key < static_cast<int>(InputQueue::kKeys); ++key)
        if (queue.isDown(key)) input.keys.push_back(key);
    for (const unsigned each : frame.characters) {
        std::array<char, 5> bytes{};
        ImTextCharToUtf8(bytes.data(), each);
        input.text += bytes.data();
    }
    return input;
}

bool isEnterPressed(bool repeats) {
    return isKeyPressed(GLFW_KEY_ENTER, repeats) || isKeyPressed(GLFW_KEY_KP_ENTER, repeats);
}

void activateItem(unsigned id, bool prefersInput) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavNextActivateId = id;
    context.NavNextActivateFlags = prefersInput ? ImGuiActivateFlags_PreferInput : ImGuiActivateFlags_None;
}

#if IMGUI_VERSION_NUM >= 18700

namespace {

/// ImGuiKey_None for keys that ImGui does not know.
ImGuiKey keyOf(int key) {
    const auto within = [&](int first, int last, ImGuiKey to) {
        return key >= first && key <= last ? static_cast<ImGuiKey>(to + (key - first)) : ImGuiKey_None;
    };
    for (const ImGuiKey each :
         {within(GLFW_KEY_A, GLFW_KEY_Z, ImGuiKey_A), within(GLFW_KEY_0, GLFW_KEY_9, ImGuiKey_0),
          within(GLFW_KEY_F1, GLFW_KEY_F12, ImGuiKey_F1),
          within(GLFW_KEY_KP_0, GLFW_KEY_KP_9, ImGuiKey_Keypad0)})
        if (each != ImGuiKey_None) return each;
    static constexpr std::array<std::pair<int, ImGuiKey>, 47> kKeys{{
        {GLFW_KEY_TAB, ImGuiKey_Tab},
        {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
        {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
        {GLFW_KEY_UP, ImGuiKey_UpArrow},
        {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
        {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
        {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
        {GLFW_KEY_HOME, ImGuiKey_Home},
        {GLFW_KEY_END, ImGuiKey_End},
        {GLFW_KEY_INSERT, ImGuiKey_Insert},
        {GLFW_KEY_DELETE, ImGuiKey_Delete},
        {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
        {GLFW_KEY_SPACE, ImGuiKey_Space},
        {GLFW_KEY_ENTER, ImGuiKey_Enter},
        {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
        {GLFW_KEY_APOSTROPHE, ImGuiKey_Apostrophe},
        {GLFW_KEY_COMMA, ImGuiKey_Comma},
        {GLFW_KEY_MINUS, ImGuiKey_Minus},
        {GLFW_KEY_PERIOD, ImGuiKey_Period},
        {GLFW_KEY_SLASH, ImGuiKey_Slash},
        {GLFW_KEY_SEMICOLON, ImGuiKey_Semicolon},
        {GLFW_KEY_EQUAL, ImGuiKey_Equal},
        {GLFW_KEY_LEFT_BRACKET, ImGuiKey_LeftBracket},
        {GLFW_KEY_BACKSLASH, ImGuiKey_Backslash},
        {GLFW_KEY_RIGHT_BRACKET, ImGuiKey_RightBracket},
        {GLFW_KEY_GRAVE_ACCENT, ImGuiKey_GraveAccent},
        {GLFW_KEY_CAPS_LOCK, ImGuiKey_CapsLock},
        {GLFW_KEY_SCROLL_LOCK, ImGuiKey_ScrollLock},
        {GLFW_KEY_NUM_LOCK, ImGuiKey_NumLock},
        {GLFW_KEY_PRINT_SCREEN, ImGuiKey_PrintScreen},
        {GLFW_KEY_PAUSE, ImGuiKey_Pause},
        {GLFW_KEY_KP_DECIMAL, ImGuiKey_KeypadDecimal},
        {GLFW_KEY_KP_DIVIDE, ImGuiKey_KeypadDivide},
        {GLFW_KEY_KP_MULTIPLY, ImGuiKey_KeypadMultiply},
        {GLFW_KEY_KP_SUBTRACT, ImGuiKey_KeypadSubtract},
        {GLFW_KEY_KP_ADD, ImGuiKey_KeypadAdd},
        {GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
        {GLFW_KEY_KP_EQUAL, ImGuiKey_KeypadEqual},
        {GLFW_KEY_LEFT_SHIFT, ImGuiKey_LeftShift},
        {GLFW_KEY_LEFT_CONTROL, ImGuiKey_LeftCtrl},
        {GLFW_KEY_LEFT_ALT, ImGuiKey_LeftAlt},
        {GLFW_KEY_LEFT_SUPER, ImGuiKey_LeftSuper},
        {GLFW_KEY_RIGHT_SHIFT, ImGuiKey_RightShift},
        {GLFW_KEY_RIGHT_CONTROL, ImGuiKey_RightCtrl},
        {GLFW_KEY_RIGHT_ALT, ImGuiKey_RightAlt},
        {GLFW_KEY_RIGHT_SUPER, ImGuiKey_RightSuper},
        {GLFW_KEY_MENU, ImGuiKey_Menu},
    }};
    const auto* found =
        std::find_if(kKeys.begin(), kKeys.end(), [&](const auto& each) { return each.first == key; });
    return found == kKeys.end() ? ImGuiKey_None : found->second;
}

}  // namespace

void giveToImGui(const FrameInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    tellOfMouse(input);
    // The queue of glibra has already divided the input into frames, and the backend's events are the same
    // once more.
    io.ConfigInputTrickleEventQueue = false;
    io.ClearEventsQueue();
    io.AddKeyEvent(ImGuiMod_Ctrl, isDown(input, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL));
    io.AddKeyEvent(ImGuiMod_Shift, isDown(input, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT));
    io.AddKeyEvent(ImGuiMod_Alt, isDown(input, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT));
    io.AddKeyEvent(ImGuiMod_Super, isDown(input, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER));
    for (int key = 0; key < static_cast<int>(InputQueue::kKeys); ++key)
        if (const ImGuiKey to = keyOf(key); to != ImGuiKey_None) io.AddKeyEvent(to, isDown(input, key, key));
    io.AddMousePosEvent(input.mouseX, input.mouseY);
    for (unsigned i = 0; i < kButtons; ++i)
        io.AddMouseButtonEvent(static_cast<int>(i), (input.buttons >> i & 1U) != 0);
    if (input.wheel != 0) io.AddMouseWheelEvent(0, input.wheel);
    giveText(input.text);
}

bool isKeyPressed(int key, bool repeats) {
    const ImGuiKey to = keyOf(key);
    return to != ImGuiKey_None && ImGui::IsKeyPressed(to, repeats);
}

bool isKeyDown(int key) {
    const ImGuiKey to = keyOf(key);
    return to != ImGuiKey_None && ImGui::IsKeyDown(to);
}

void giveKeyboardToNext() {
    // ImGui 1.90 passes over items outside of the focused window.
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
}

void keepFromImGui(int key) {
    // ImGui moves its focus only by keys that nobody owns.
    ImGui::SetKeyOwner(keyOf(key), ImHashStr("window"));
}

struct HiddenKeys::State {
    std::vector<std::pair<ImGuiKeyData*, ImGuiKeyData>> kept;
};

HiddenKeys::HiddenKeys(std::span<const int> keys) : state_(std::make_unique<State>()) {
    for (const int each : keys) {
        ImGuiKeyData* data = ImGui::GetKeyData(keyOf(each));
        state_->kept.emplace_back(data, *data);
        data->Down = false;
        data->DownDuration = data->DownDurationPrev = -1;
    }
}

HiddenKeys::~HiddenKeys() {
    for (const auto& [data, value] : state_->kept) *data = value;
}

#else

namespace {

/// In menus and lists Enter does what a click does, as in later versions; in this one it only begins to edit.
void chooseByEnter(const FrameInput& input) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.OpenPopupStack.empty() || context.ActiveId != 0 || context.NavDisableHighlight) return;
    for (const int key : {GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER})
        if (isDown(input, key, key) && context.IO.KeysDownDuration[key] < 0)
            activateItem(context.NavId, false);
}

}  // namespace

void giveToImGui(const FrameInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    tellOfMouse(input);
    chooseByEnter(input);
    io.ClearInputCharacters();
    giveText(input.text);
    io.KeyMap[ImGuiKey_Tab] = GLFW_KEY_TAB;
    io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    for (const int key : input.keys)
        if (key >= 0 && key < static_cast<int>(std::size(io.KeysDown))) io.KeysDown[key] = true;
    io.KeyCtrl = isDown(input, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = isDown(input, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = isDown(input, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = isDown(input, GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
    io.MousePos = {input.mouseX, input.mouseY};
    for (unsigned i = 0; i < kButtons; ++i) io.MouseDown[i] = (input.buttons >> i & 1U) != 0;
    io.MouseWheel = input.wheel;
}

bool isKeyPressed(int key, bool repeats) {
    return ImGui::IsKeyPressed(key, repeats);
}

bool isKeyDown(int key) {
    return ImGui::IsKeyDown(key);
}

void giveKeyboardToNext() {
    ImGui::SetKeyboardFocusHere();
}

void keepFromImGui(int key) {
    ImGui::GetIO().KeyMap[key == GLFW_KEY_TAB ? ImGuiKey_Tab : ImGuiKey_Escape] = -1;
}

struct HiddenKeys::State {
    std::vector<std::pair<ImGuiKey, int>> kept;
};

HiddenKeys::HiddenKeys(std::span<const int> keys) : state_(std::make_unique<State>()) {
    const std::span map(ImGui::GetIO().KeyMap);
    for (const int key : keys)
        for (std::size_t i = 0; i < map.size(); ++i)
            if (map[i] == key) state_->kept.emplace_back(static_cast<ImGuiKey>(i), std::exchange(map[i], -1));
}

HiddenKeys::~HiddenKeys() {
    for (const auto& [key, code] : state_->kept) ImGui::GetIO().KeyMap[key] = code;
}

#endif

}  // namespace glibra::view
