#include "view/window/input_replay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace glibra::view {

void InputRecord::addDropped(const std::vector<std::string>& files) {
    dropped_.insert(dropped_.end(), files.begin(), files.end());
}

void InputRecord::add(FrameInput frame, const std::vector<MousePoint>& way, std::pair<int, int> size) {
    if (way.size() > 1) frame.way = way;
    if (size != size_) frame.windowSize = size_ = size;
    frame.dropped = std::exchange(dropped_, {});
    recorder_.add(frame);
}

const FrameInput& InputReplay::next() {
    const FrameInput& frame = frames_[next_++];
    const auto isDown = [&](int left, int right) {
        return std::any_of(frame.keys.begin(), frame.keys.end(),
                           [&](int key) { return key == left || key == right; });
    };
    const bool control = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    const bool shift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    pressed_.clear();
    for (const int key : frame.keys)
        if (std::find(keys_.begin(), keys_.end(), key) == keys_.end())
            pressed_.push_back({key, control, shift});
    keys_ = frame.keys;
    return frame;
}

}  // namespace glibra::view
