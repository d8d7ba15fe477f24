#pragma once
// Distributes keys, characters and the mouse to frames, in the order in which they arrived. Dear ImGui gets
// the keys, the buttons and the mouse as they are when a frame begins. In a slow scene it would miss what
// happened between two frames: a key or button that was pressed and released, the order of several, and where
// the mouse was when a button changed.

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "view/window/platform/display.h"

namespace glibra::view {

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

}  // namespace glibra::view
