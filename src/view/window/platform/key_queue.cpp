#include "view/window/platform/key_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace glibra::view {
namespace {

bool isModifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}
/// True for a key that without modifiers only types a character.
bool isPrinted(int key) {
    return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
}

}  // namespace

void KeyQueue::add(std::span<const Display::KeyEvent> events) {
    for (const Display::KeyEvent& each : events)
        if (each.character != 0 || (each.key > 0 && each.key < static_cast<int>(down_.size())))
            waiting_.push_back(each);
}

bool KeyQueue::isEitherDown(int left, int right) const {
    return down_[static_cast<std::size_t>(left)] || down_[static_cast<std::size_t>(right)];
}

std::vector<Display::KeyPress> KeyQueue::begin() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClearInputCharacters();
    std::vector<Display::KeyPress> pressed;
    std::vector<int> released;
    bool isFull = false;
    for (; !waiting_.empty() && !isFull; waiting_.pop_front()) {
        const Display::KeyEvent event = waiting_.front();
        if (event.character != 0) {
            io.AddInputCharacter(event.character);
            continue;
        }
        // A key must be up for one frame before it can be pressed again.
        if (event.isDown && std::find(released.begin(), released.end(), event.key) != released.end()) break;
        down_[static_cast<std::size_t>(event.key)] = event.isDown;
        if (!event.isDown) released.push_back(event.key);
        if (!event.isDown || isModifier(event.key)) continue;
        const bool control = isEitherDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
        pressed.push_back({event.key, control});
        isFull = control || !isPrinted(event.key) || isEitherDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    }
    std::copy(down_.begin(), down_.end(), std::begin(io.KeysDown));
    io.KeyCtrl = isEitherDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = isEitherDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = isEitherDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = isEitherDown(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
    return pressed;
}

}  // namespace glibra::view
