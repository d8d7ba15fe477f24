#include "view/session/wheel.h"

#include <algorithm>
#include <cmath>

namespace glibra::view {

double Wheel::take(double notches, double seconds) {
    constexpr double kBurstEnds = .12;  // seconds without a step
    constexpr int kMomentum = 3;        // a finger rarely slows down that evenly
    constexpr double kMostAtOnce = 2;
    if (notches == 0 || !std::isfinite(notches)) return 0;
    const bool continues = seconds - lastTime_ < kBurstEnds && (notches > 0) == (last_ > 0);
    const bool isWheel = notches == std::round(notches);
    if (!continues || std::abs(notches) > std::abs(last_) || isWheel)
        shrinking_ = 0;
    else if (std::abs(notches) < std::abs(last_))
        ++shrinking_;
    last_ = notches;
    lastTime_ = seconds;
    return shrinking_ >= kMomentum ? 0 : std::clamp(notches, -kMostAtOnce, kMostAtOnce);
}

}  // namespace glibra::view
