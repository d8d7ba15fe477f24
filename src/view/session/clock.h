#pragma once
// The time that a scene sees: it plays, pauses, steps and runs at any speed. The class never reads a real
// clock; its owner reports how much real time has passed.

#include <string>
#include <vector>

#include "render/live/knobs.h"

namespace glibra::view {

// Values that move between the ends of their ranges. They are functions of the scene's time, so that the same
// time shows the same picture again.

/// One animated knob with a range: all its components.
struct Animation {
    scene::ProgramIndex program{};
    std::string tag;
    double begin = 0;            ///< seconds of the scene's time
    std::vector<double> phases;  ///< of the components at `begin`, 0..2: up at 0..1, down at 1..2
    std::vector<double> before;  ///< the values that undo returns to

    [[nodiscard]] bool isOf(const render::Knob& knob) const {
        return knob.program == program && knob.tag == tag;
    }
};

constexpr double kAnimationSeconds = 4;  ///< from one end to the other

/// Begins at the knob's current values, upwards.
Animation animationOf(const render::Knob& knob, double time);
/// The values of the animated knob at that time: from end to end and back, evenly on the slider's scale.
std::vector<double> valuesAt(const Animation& animation, const render::Knob& knob, double time);

class Clock {
  public:
    /// Seconds since the scene was loaded, as shaders see them.
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] bool isPlaying() const { return playing_; }
    [[nodiscard]] double speed() const { return speed_; }

    void play(bool on) { playing_ = on; }
    /// Scene seconds per real second, clamped to -1000..1000. A negative speed runs backwards; a value that
    /// is not finite is ignored.
    void setSpeed(double speed);
    /// Times below 0 become 0; a value that is not finite is ignored.
    void setTime(double seconds);
    /// Pauses, and moves the time by `frames` frames of 1/30 second each, times the speed. `frames` may be
    /// negative.
    void step(int frames);
    /// Reports that `seconds` of real time have passed. Returns true if the scene's time has changed.
    bool advance(double seconds);

    static constexpr double kFrameSeconds = 1.0 / 30;

  private:
    double time_ = 0;
    double speed_ = 1;
    bool playing_ = true;
};

}  // namespace glibra::view
