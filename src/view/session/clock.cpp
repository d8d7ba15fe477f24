#include "view/session/clock.h"

#include <algorithm>
#include <cmath>

namespace glibra::view {

void Clock::setSpeed(double speed) {
    constexpr double kFastest = 1000;
    if (std::isfinite(speed)) speed_ = std::clamp(speed, -kFastest, kFastest);
}

void Clock::setTime(double seconds) {
    if (std::isfinite(seconds)) time_ = std::max(0.0, seconds);
}

void Clock::step(int frames) {
    playing_ = false;
    setTime(time_ + frames * kFrameSeconds * speed_);
}

bool Clock::advance(double seconds) {
    if (!playing_ || speed_ == 0 || seconds <= 0) return false;
    const double before = time_;
    setTime(time_ + seconds * speed_);
    return time_ != before;
}

}  // namespace glibra::view
