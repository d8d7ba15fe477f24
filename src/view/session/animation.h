#pragma once
// Values that move between the ends of their ranges. They are functions of the scene's time, so that the same
// time shows the same picture again.

#include <string>
#include <vector>

#include "view/scene/knobs.h"

namespace glibra::view {

/// One animated knob with a range: all its components.
struct Animation {
    scene::ProgramIndex program{};
    std::string tag;
    double begin = 0;            ///< seconds of the scene's time
    std::vector<double> phases;  ///< of the components at `begin`, 0..2: up at 0..1, down at 1..2
    std::vector<double> before;  ///< the values that undo returns to

    [[nodiscard]] bool isOf(const Knob& knob) const { return knob.program == program && knob.tag == tag; }
};

constexpr double kAnimationSeconds = 4;  ///< from one end to the other

/// Begins at the knob's current values, upwards.
Animation animationOf(const Knob& knob, double time);
/// The values of the animated knob at that time: from end to end and back, evenly on the slider's scale.
std::vector<double> valuesAt(const Animation& animation, const Knob& knob, double time);

}  // namespace glibra::view
