#include "view/window/key_taps.h"

#include <imgui.h>

#include <iterator>
#include <utility>

namespace glibra::view {

void KeyTaps::add(std::span<const Display::KeyPress> pressed) {
    const ImGuiIO& io = ImGui::GetIO();
    for (const Display::KeyPress& each : pressed)
        if (each.key > 0 && each.key < static_cast<int>(std::size(io.KeysDown)) && !io.KeysDown[each.key])
            waiting_.push_back(each);
}

void KeyTaps::begin() {
    before_ = std::exchange(down_, 0);
    // The same key has to be up for a frame to be pressed once more.
    if (waiting_.empty() || waiting_.front().key == before_) return;
    const Display::KeyPress tap = waiting_.front();
    waiting_.pop_front();
    ImGuiIO& io = ImGui::GetIO();
    if (io.KeysDown[tap.key]) return;
    down_ = tap.key;
    io.KeysDown[down_] = true;
    control_ = std::exchange(io.KeyCtrl, tap.control);
    shift_ = std::exchange(io.KeyShift, tap.shift);
}

void KeyTaps::end() {
    if (down_ == 0) return;
    ImGuiIO& io = ImGui::GetIO();
    io.KeysDown[down_] = false;
    io.KeyCtrl = control_;
    io.KeyShift = shift_;
}

}  // namespace glibra::view
