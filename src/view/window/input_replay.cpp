#include "view/window/input_replay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "view/window/platform/keys.h"

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
    const bool control = isDown(frame, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    const bool shift = isDown(frame, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    pressed_.clear();
    for (const int key : frame.keys)
        if (std::ranges::find(keys_, key) == keys_.end()) pressed_.push_back({key, control, shift});
    keys_ = frame.keys;
    return frame;
}

}  // namespace glibra::view
