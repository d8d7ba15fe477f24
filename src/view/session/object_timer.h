#pragma once
// Measures how long the objects of a frame take: its draws and dispatches, without clears, panels, and the
// exchange of the window's buffers. This is what glman's frame rate counts.

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

#include "render/draw/frame.h"

namespace glibra::view {

class ObjectTimer {
  public:
    /// Measures the frame that `drawer` draws next. `plan` is the drawer's.
    void begin(render::FrameDrawer& drawer, const plan::FramePlan& plan);
    /// Ends the measurement of that frame.
    void end(render::FrameDrawer& drawer);
    /// Forgets the frames so far.
    void forget() { measured_ = 0; }
    /// Real time per frame, mean of the last frames; the device is idle before and after. Nothing before the
    /// first.
    [[nodiscard]] std::optional<double> milliseconds() const;

    static constexpr std::size_t kFrames = 16;  ///< that the mean is taken of

  private:
    using Clock = std::chrono::steady_clock;
    void start();
    void stop();

    std::optional<Clock::time_point> started_;  ///< of the node that is executed
    double now_ = 0;                            ///< milliseconds of this frame so far
    std::array<double, kFrames> frames_{};
    std::size_t measured_ = 0;
};

}  // namespace glibra::view
