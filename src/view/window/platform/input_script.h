#pragma once
// Input of mouse and keys, frame by frame, as JSON lines: --record writes them and --replay plays them back.

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/window/platform/display.h"

namespace glibra::view {

/// The input of one frame. Times are not recorded: a replayed frame lasts 1/60 second.
struct FrameInput {
    float mouseX = 0, mouseY = 0;  ///< screen coordinates
    unsigned buttons = 0;          ///< bit 0 left, 1 right, 2 middle
    float wheel = 0;
    std::vector<MousePoint> way;  ///< InputQueue::Frame::way, if it has more points than one
    std::vector<int> keys;        ///< GLFW codes of the keys that are down
    std::string text;             ///< typed characters, UTF-8
    std::optional<std::pair<int, int>> windowSize;
    std::optional<std::string> open;   ///< a scene to open in the shown tab
    std::vector<std::string> dropped;  ///< files dropped on the window
    friend bool operator==(const FrameInput&, const FrameInput&) = default;
};

class InputRecorder {
  public:
    explicit InputRecorder(const std::filesystem::path& file) : out_(file) {}

    void add(const FrameInput& frame);

  private:
    std::ofstream out_;
};

/// Reads the frames of a file; invalid lines are skipped.
std::vector<FrameInput> readInput(const std::filesystem::path& file);

}  // namespace glibra::view
