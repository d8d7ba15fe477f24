#include "view/session/clock.h"

#include <algorithm>
#include <cmath>

#include "view/scene/slider_scale.h"

namespace glibra::view {

Animation animationOf(const render::Knob& knob, double time) {
    Animation animation{knob.program, knob.tag, time, {}, knob.current};
    const SliderScale scale = scaleOf(knob);
    for (const double each : knob.current) animation.phases.push_back(scale.positionOf(each));
    return animation;
}

std::vector<double> valuesAt(const Animation& animation, const render::Knob& knob, double time) {
    const SliderScale scale = scaleOf(knob);
    std::vector<double> values = knob.current;
    for (std::size_t i = 0; i < values.size() && i < animation.phases.size(); ++i) {
        const double phase = animation.phases[i] + (time - animation.begin) / kAnimationSeconds;
        const double turned = phase - 2 * std::floor(phase / 2);
        values[i] = scale.valueAt(turned <= 1 ? turned : 2 - turned, true);
    }
    return values;
}

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
