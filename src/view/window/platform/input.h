#pragma once
// What the mouse and the keys do, frame by frame: as it arrives, as a record, and played back.

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "view/window/platform/display.h"

namespace glibra::view {

// Distributes keys, characters and the mouse to frames, in the order in which they arrived. Dear ImGui gets
// the keys, the buttons and the mouse as they are when a frame begins. In a slow scene it would miss what
// happened between two frames: a key or button that was pressed and released, the order of several, and where
// the mouse was when a button changed.

class InputQueue {
  public:
    /// The input of one frame.
    struct Frame {
        std::vector<unsigned> characters;
        std::vector<Display::KeyPress> pressed;
        std::optional<MousePoint> mouse;  ///< nothing: not known, or outside the window
        unsigned buttons = 0;             ///< those that are down; bit 0 left, 1 right, 2 middle
        double wheel = 0;                 ///< notches
        /// Where the mouse has been since the frame before, while a button was down; the last is `mouse`.
        std::vector<MousePoint> way;
    };

    void add(std::span<const Display::InputEvent> events);
    /// The next frame has characters of one word, or at most one key that edits or is pressed with Ctrl or
    /// Alt and what it types, or at most one change of a button, where the mouse was at that time; a button
    /// changes in a later frame than the mouse was moved, as some widgets of ImGui take clicks only where
    /// they have seen the mouse before.
    Frame next();
    /// True if further frames are needed for the remaining input.
    [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); }
    /// True if that key (GLFW code) is down.
    [[nodiscard]] bool isDown(int key) const { return down_.at(static_cast<std::size_t>(key)); }

    static constexpr std::size_t kKeys = 512;

  private:
    [[nodiscard]] bool isEitherDown(int left, int right) const { return isDown(left) || isDown(right); }
    void takeMouse(const Display::InputEvent& event, Frame& frame);

    std::deque<Display::InputEvent> waiting_;
    std::array<bool, kKeys> down_{};  ///< by GLFW key code
    unsigned buttons_ = 0;
    std::optional<MousePoint> mouse_;
};

// Input of mouse and keys, frame by frame, as JSON lines: --record writes them and --replay plays them back.

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

/// True if one of these keys is down in that input.
bool isDown(const FrameInput& input, int left, int right);

class InputRecord {
  public:
    explicit InputRecord(const std::filesystem::path& file) : out_(file) {}

    /// Files that were dropped before the next frame.
    void addDropped(const std::vector<std::string>& files);
    /// `way`: of the mouse since the frame before. `size`: of the window, in screen coordinates.
    void add(FrameInput frame, const std::vector<MousePoint>& way, std::pair<int, int> size);

  private:
    std::ofstream out_;
    std::vector<std::string> dropped_;
    std::pair<int, int> size_;
};

/// Reads the frames of a file; invalid lines are skipped.
std::vector<FrameInput> readInput(const std::filesystem::path& file);

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
