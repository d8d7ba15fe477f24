#include "view/window/platform/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace glibra::view {
namespace {

using EventKind = Display::InputEvent::Kind;

bool isModifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}
/// True for a key that without modifiers only types a character.
bool isPrinted(int key) {
    return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
}

}  // namespace

void InputQueue::add(std::span<const Display::InputEvent> events) {
    for (const Display::InputEvent& each : events)
        if (each.kind != EventKind::key || (each.code > 0 && each.code < static_cast<int>(kKeys)))
            waiting_.push_back(each);
}

void InputQueue::takeMouse(const Display::InputEvent& event, Frame& frame) {
    switch (event.kind) {
        case EventKind::move:
            mouse_ = event.at;
            if (buttons_ != 0) frame.way.push_back(event.at);
            return;
        case EventKind::leave:
            if (buttons_ == 0) mouse_.reset();  // a drag goes on outside
            return;
        case EventKind::wheel:
            frame.wheel += event.at.y;
            return;
        default:
            const unsigned bit = 1U << static_cast<unsigned>(event.code);
            buttons_ = event.isDown ? buttons_ | bit : buttons_ & ~bit;
    }
}

InputQueue::Frame InputQueue::next() {
    Frame frame;
    std::vector<int> released;
    bool isFull = false, hasKeys = false, hasButton = false, hasMoved = false, hasAlt = false;
    for (; !waiting_.empty() && !isFull; waiting_.pop_front()) {
        const Display::InputEvent event = waiting_.front();
        const bool isKey = event.kind == EventKind::key || event.kind == EventKind::character;
        if (!isKey) {
            const bool isButton = event.kind == EventKind::button;
            if (hasButton || (isButton && (hasKeys || hasMoved || !frame.way.empty()))) break;
            hasButton = isButton;
            const std::optional<MousePoint> before = mouse_;
            takeMouse(event, frame);
            hasMoved = hasMoved || mouse_ != before;
            continue;
        }
        if (hasButton || !frame.way.empty()) break;
        hasKeys = true;
        const bool control = isEitherDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
        const bool alt = isEitherDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
        if (event.kind == EventKind::character) {
            if (control && !alt) continue;  // Windows has a blank for Ctrl+Space
            // A word at most, so that undo goes by words however slow frames are.
            if (event.code != ' ' && !frame.characters.empty() && frame.characters.back() == ' ') break;
            frame.characters.push_back(static_cast<unsigned>(event.code));
            continue;
        }
        // A key must be up for one frame before it can be pressed again.
        if (event.isDown && std::ranges::find(released, event.code) != released.end()) break;
        const bool edits =
            event.isDown && !isModifier(event.code) && (control || alt || !isPrinted(event.code));
        // Alt alone opens the menu; ImGui has to see it down.
        const bool isAlt = event.code == GLFW_KEY_LEFT_ALT || event.code == GLFW_KEY_RIGHT_ALT;
        if (isAlt && !event.isDown && hasAlt) break;
        hasAlt = hasAlt || (isAlt && event.isDown);
        // What takes such a key, such as the list of words, has to know the text before it.
        if (edits && !frame.characters.empty()) break;
        down_.at(static_cast<std::size_t>(event.code)) = event.isDown;
        if (!event.isDown) released.push_back(event.code);
        if (!event.isDown || isModifier(event.code)) continue;
        const bool shift = isEitherDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
        frame.pressed.push_back({event.code, control, shift});
        isFull = edits;
    }
    frame.mouse = mouse_;
    frame.buttons = buttons_;
    return frame;
}

}  // namespace glibra::view
