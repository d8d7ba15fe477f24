#include "view/session/animation.h"

#include <cmath>

#include "view/scene/slider_scale.h"

namespace glibra::view {

Animation animationOf(const Knob& knob, double time) {
    Animation animation{knob.program, knob.tag, time, {}, knob.current};
    const SliderScale scale = scaleOf(knob);
    for (const double each : knob.current) animation.phases.push_back(scale.positionOf(each));
    return animation;
}

std::vector<double> valuesAt(const Animation& animation, const Knob& knob, double time) {
    const SliderScale scale = scaleOf(knob);
    std::vector<double> values = knob.current;
    for (std::size_t i = 0; i < values.size() && i < animation.phases.size(); ++i) {
        const double phase = animation.phases[i] + (time - animation.begin) / kAnimationSeconds;
        const double turned = phase - 2 * std::floor(phase / 2);
        values[i] = scale.valueAt(turned <= 1 ? turned : 2 - turned, true);
    }
    return values;
}

}  // namespace glibra::view
