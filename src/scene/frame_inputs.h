#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace glibra::scene {

/// What a frame is a function of, besides the script and its files.
struct FrameInputs {
    double time = 0;                  ///< seconds since loading
    int width = 0, height = 0;        ///< pixels of the window; 0: as the scene states
    double mouseX = .5, mouseY = .5;  ///< 0..1 from the lower left corner of the window
    bool isMouseDown = false;
    /// Values of variables in place of those that the scene gives them, by name. A value with another number
    /// of components is ignored.
    std::map<std::string, std::vector<double>, std::less<>> variables{};
    std::map<std::string, std::string, std::less<>> words{};  ///< the same for choices
    /// The number of the step that each Step block is evaluated for, in the order of the text; 0 for those
    /// beyond the end. `time` inside such a block is tick / rate. Variables that are computed outside of it
    /// have the values of `time` above, which should therefore be tick / rate, too.
    std::vector<std::int64_t> ticks{};
    /// The step since which each Step block runs, because its values after `reset` have changed; 0 for those
    /// beyond the end. `tick` counts from it.
    std::vector<std::int64_t> firstTicks{};
    /// Seconds since the step before, for `camera.prev` in a Step block; 0: those since the frame before.
    double sinceStepBefore = 0;
    friend bool operator==(const FrameInputs&, const FrameInputs&) = default;
};

}  // namespace glibra::scene
