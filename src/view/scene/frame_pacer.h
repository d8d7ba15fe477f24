#pragma once
// When the frames of a moving scene are due. Where the driver waits for the screen it rules; where it does
// not, this keeps a scene from being drawn more often than the screen shows it.

#include <algorithm>

namespace glibra::view {

class FramePacer {
  public:
    /// How often the screen shows a picture, a second; more than 0. `driverWaits`: presenting may wait for
    /// the screen.
    FramePacer(double framesPerSecond, bool driverWaits) : driverWaits_(driverWaits) {
        setRate(framesPerSecond);
    }

    /// The last tenth of the waiting is left to a driver that waits: screens rarely have the rate that they
    /// say, and of one a little faster a picture would be missed now and then.
    void setRate(double framesPerSecond) { period_ = (driverWaits_ ? kPart : 1) / framesPerSecond; }
    /// A frame begins; `now` in seconds of any clock that runs evenly.
    void begin(double now) { begun_ = now; }
    /// Seconds from `now` until the next one should begin, 0 if it should already have.
    [[nodiscard]] double rest(double now) const { return std::max(0.0, begun_ + period_ - now); }

  private:
    static constexpr double kPart = .9;
    bool driverWaits_ = false;
    double period_ = 0;
    double begun_ = 0;
};

}  // namespace glibra::view
