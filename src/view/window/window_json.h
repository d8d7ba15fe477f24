#pragma once
// The state of the window as JSON text, for programs that watch or test it (`--state`).

#include <cstdint>
#include <string>
#include <utility>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// What the loop of the window measures.
struct LoopState {
    std::pair<int, int> windowSize;  ///< screen coordinates
    std::uint64_t framesPresented = 0, reloads = 0;
    double loadMilliseconds = 0;           ///< of the last reload
    double firstDrawMilliseconds = 0;      ///< of the first frame after it
    double editToPictureMilliseconds = 0;  ///< from saving a file to the picture on the screen
    double refreshRate = 0;                ///< Hz
    bool hasSwapControl = false;
    bool isWaiting = false;  ///< for events, with nothing to draw
};

/// The session, the loop, the panels and the widgets of the shown tab: one JSON object.
std::string windowJson(const Ui& ui, const LoopState& loop);

}  // namespace glibra::view
