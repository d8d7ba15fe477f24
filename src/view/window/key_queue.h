#pragma once
// Keys and characters in the order in which they came, dealt out to frames. ImGui 1.86 looks at what is down
// when a frame begins: what went down and up again since the last one it would miss, and of several keys it
// would not know the order, which on a slow scene garbles what a user types quickly.

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "view/window/display.h"

namespace glibra::view {

class KeyQueue {
  public:
    void add(std::span<const Display::KeyEvent> events);
    /// Before ImGui::NewFrame(): puts into ImGui what may come in one frame, characters and at most one key
    /// that edits or has Ctrl or Alt with it. Returns the keys that went down.
    std::vector<Display::KeyPress> begin();
    /// True if frames are needed for the rest.
    [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); }

  private:
    [[nodiscard]] bool isEitherDown(int left, int right) const;

    std::deque<Display::KeyEvent> waiting_;
    std::array<bool, 512> down_{};  ///< by GLFW's number, as ImGui knows them
};

}  // namespace glibra::view
