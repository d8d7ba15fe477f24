#pragma once
// Keys that went down and up again between two frames. ImGui 1.86 looks at what is down when a frame begins
// and would miss them, which on a slow scene loses what a user types quickly.

#include <deque>
#include <span>

#include "view/window/display.h"

namespace glibra::view {

class KeyTaps {
  public:
    /// The keys that went down since the last frame; those still down are ImGui's own business.
    void add(std::span<const Display::KeyPress> pressed);
    /// Before ImGui::NewFrame(): the next of them counts as down in this frame.
    void begin();
    /// After the frame.
    void end();
    /// True if frames are needed for more of them.
    [[nodiscard]] bool areWaiting() const { return !waiting_.empty(); }

  private:
    std::deque<Display::KeyPress> waiting_;
    int down_ = 0;                          ///< key that counts as down in this frame; 0: none
    int before_ = 0;                        ///< the one of the frame before
    bool control_ = false, shift_ = false;  ///< as they really are
};

}  // namespace glibra::view
