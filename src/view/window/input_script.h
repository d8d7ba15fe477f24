#pragma once
// What the mouse and the keys did, frame by frame, as JSON lines: recorded by --record, played by --replay.

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glibra::view {

/// Input of one frame. Times are not recorded: a replayed frame lasts 1/60 second.
struct FrameInput {
    float mouseX = 0, mouseY = 0;  ///< screen coordinates
    unsigned buttons = 0;          ///< bit 0 left, 1 right, 2 middle
    float wheel = 0;
    std::vector<int> keys;  ///< GLFW's numbers of the keys that are down
    std::string text;       ///< characters entered, UTF-8
    std::optional<std::pair<int, int>> windowSize;
    std::optional<std::string> open;   ///< a scene, in place of the shown one
    std::vector<std::string> dropped;  ///< files that fell on the window
    friend bool operator==(const FrameInput&, const FrameInput&) = default;
};

class InputRecorder {
  public:
    explicit InputRecorder(const std::filesystem::path& file) : out_(file) {}
    [[nodiscard]] bool isWorking() const { return static_cast<bool>(out_); }
    void add(const FrameInput& frame);

  private:
    std::ofstream out_;
};

/// Lines that are no frame are passed over.
std::vector<FrameInput> readInput(const std::filesystem::path& file);

/// ImGui's input of this frame as the backend has filled it, to be recorded.
FrameInput presentInput();
/// Replaces it.
void imposeInput(const FrameInput& frame);

}  // namespace glibra::view
