#pragma once
// Decides when the next frame of a moving scene is due. A driver that waits for the screen sets the pace
// itself; without one, this keeps a scene from being drawn more often than the screen shows it.

#include <algorithm>

namespace glibra::view {

class FramePacer {
  public:
    /// `framesPerSecond`: the screen's refresh rate, more than 0. `driverWaits`: presenting may wait for the
    /// screen.
    FramePacer(double framesPerSecond, bool driverWaits) : driverWaits_(driverWaits) {
        setRate(framesPerSecond);
    }

    /// A driver that waits does the last tenth of the waiting: a screen rarely has exactly the rate that it
    /// reports, and a slightly faster screen would otherwise miss a frame now and then.
    void setRate(double framesPerSecond) { period_ = (driverWaits_ ? kPart : 1) / framesPerSecond; }
    /// A frame begins at `now`, in seconds of any steady clock.
    void begin(double now) { begun_ = now; }
    /// Seconds from `now` until the next frame is due; 0 if it is overdue.
    [[nodiscard]] double secondsToNext(double now) const { return std::max(0.0, begun_ + period_ - now); }

  private:
    static constexpr double kPart = .9;
    bool driverWaits_ = false;
    double period_ = 0;
    double begun_ = 0;
};

}  // namespace glibra::view
