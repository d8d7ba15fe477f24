#pragma once
// Distributes keys and characters to frames, in the order in which they arrived. ImGui 1.86 looks at the keys
// that are down when a frame begins. It would miss a key that was pressed and released since the last frame,
// and would not know the order of several keys: in a slow scene that garbles quickly typed text.

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "view/window/platform/display.h"

namespace glibra::view {

class KeyQueue {
  public:
    void add(std::span<const Display::KeyEvent> events);
    /// Call before ImGui::NewFrame(). Passes the input of one frame to ImGui: characters and at most one key
    /// that edits or is pressed with Ctrl or Alt. Returns the pressed keys.
    std::vector<Display::KeyPress> begin();
    /// True if further frames are needed for the remaining input.
    [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); }

  private:
    [[nodiscard]] bool isEitherDown(int left, int right) const;

    std::deque<Display::KeyEvent> waiting_;
    std::array<bool, 512> down_{};  ///< by GLFW key code, as passed to ImGui
};

}  // namespace glibra::view
