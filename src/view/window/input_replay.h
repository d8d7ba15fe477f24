#pragma once
// The record of what the user does (`--record`), and its replay (`--replay`).

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "view/window/platform/display.h"
#include "view/window/platform/input_script.h"

namespace glibra::view {

class InputRecord {
  public:
    explicit InputRecord(const std::filesystem::path& file) : recorder_(file) {}

    /// Files that were dropped before the next frame.
    void addDropped(const std::vector<std::string>& files);
    /// `way`: of the mouse since the frame before. `size`: of the window, in screen coordinates.
    void add(FrameInput frame, const std::vector<MousePoint>& way, std::pair<int, int> size);

  private:
    InputRecorder recorder_;
    std::vector<std::string> dropped_;
    std::pair<int, int> size_;
};

class InputReplay {
  public:
    InputReplay() = default;
    explicit InputReplay(std::vector<FrameInput> frames) : frames_(std::move(frames)) {}

    [[nodiscard]] bool isDone() const { return next_ >= frames_.size(); }
    /// The next frame. Requires !isDone().
    const FrameInput& next();
    /// The keys that are down in the last frame and were not in the one before.
    [[nodiscard]] const std::vector<Display::KeyPress>& pressed() const { return pressed_; }

  private:
    std::vector<FrameInput> frames_;
    std::size_t next_ = 0;
    std::vector<int> keys_;  ///< of the last frame
    std::vector<Display::KeyPress> pressed_;
};

}  // namespace glibra::view
