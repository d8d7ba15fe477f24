#pragma once
// The values of a scene, which a user, animations, texts and keys set, and the time that animations follow.
// All of it can be used and tested without a device.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/live/knobs.h"

namespace glibra::view {

/// The time that a scene sees: it plays, pauses, steps and runs at any speed. The class never reads a real
/// clock; its owner reports how much real time has passed.
class Clock {
  public:
    struct State {
        double time = 0;   ///< seconds since the scene was loaded, as shaders see them
        double speed = 1;  ///< scene seconds per real second; negative: backwards
        bool isPlaying = true;
    };
    /// `changed` is called when another time is shown.
    explicit Clock(std::function<void()> changed = [] {}) : changed_(std::move(changed)) {}
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

    [[nodiscard]] const State& state() const { return state_; }
    [[nodiscard]] double time() const { return state_.time; }
    [[nodiscard]] bool isPlaying() const { return state_.isPlaying; }
    [[nodiscard]] double speed() const { return state_.speed; }

    void setState(const State& state);
    void play(bool on) { state_.isPlaying = on; }
    /// Clamped to -1000..1000; a value that is not finite is ignored.
    void setSpeed(double speed);
    /// Times below 0 become 0; a value that is not finite is ignored.
    void setTime(double seconds);
    /// Pauses at that time.
    void pauseAt(double seconds);
    /// Pauses, and moves the time by `frames` frames of 1/30 second each, times the speed. `frames` may be
    /// negative.
    void step(int frames) { pauseAt(time() + frames * kFrameSeconds * speed()); }
    /// Reports that `seconds` of real time have passed.
    void advance(double seconds);

    static constexpr double kFrameSeconds = 1.0 / 30;

  private:
    std::function<void()> changed_;
    State state_;
};

/// Animations move a knob between the ends of its range.
bool canAnimate(const render::Knob& knob);

class SceneValues {
  public:
    /// `changed` is called with each knob whose value has changed: the picture is out of date. Animations
    /// follow the clock, which must outlive the object.
    SceneValues(Clock& clock, std::function<void(const render::Knob&)> changed)
        : clock_(clock), changed_(std::move(changed)) {}

    /// The scene is about to go, because it is loaded again or the device is lost. Its values are kept.
    void leave();
    /// The scene has been loaded, with these knobs. After leave(), values return as KeptValues says, and
    /// animations go on.
    void enter(const scene::Scene& scene, std::vector<render::Knob> knobs);
    /// There is no scene any more, or another one comes: nothing is kept.
    void clear();

    [[nodiscard]] const std::vector<render::Knob>& knobs() const { return knobs_; }
    /// Null if there is none. `program` is the title of the knob's program; if it is empty, the first knob
    /// with the tag is returned.
    [[nodiscard]] const render::Knob* knob(std::string_view program, std::string_view tag) const;
    /// True if a value differs from that of the file.
    [[nodiscard]] bool isChanged() const;

    /// Sets any finite values, also beyond the knob's limits. If there are fewer values than components, the
    /// other components stay.
    void set(std::size_t knob, std::vector<double> values);
    void reset(std::size_t knob);
    void resetAll();
    /// Sets a value given as "NAME=VALUE", as on the command line. Returns what is wrong with it.
    Diagnostics setByText(const std::string& argument);
    /// Sets the values of what has the same name there.
    void setLike(const SceneValues& other);
    /// Does what the statement says about a key that is pressed.
    void press(const scene::KeyBinding& key);
    /// The same about one that has been down for these seconds, since the last call or since it was pressed.
    void hold(const scene::KeyBinding& key, double seconds);

    /// Begins or ends an animation of a knob with a range between its ends, all components together. It
    /// follows the clock, which begins to play. At the end the knob keeps the value that it has.
    void animate(std::size_t knob, bool on);
    [[nodiscard]] bool isAnimated(std::size_t knob) const;
    [[nodiscard]] bool isAnyAnimated() const;
    /// Ends all animations and returns their knobs to the values from before. Returns false if there is none.
    bool undoAnimations();
    /// The clock shows another time.
    void followClock();

    /// The knob's values, or those from before its animation.
    [[nodiscard]] const std::vector<double>& resting(std::size_t knob) const;
    /// The values that differ from the file's, those of animations as they were before.
    [[nodiscard]] render::KeptValues kept() const;
    /// Sets them, as far as the scene says the same about them as then. Returns true if a value has changed.
    bool setKept(render::KeptValues kept);

  private:
    /// Moves a knob between the ends of its range. The values are functions of the clock's time, so that the
    /// same time shows the same picture again.
    struct Animation {
        double begin = 0;            ///< seconds of the clock
        std::vector<double> phases;  ///< of the components at `begin`, 0..2: up at 0..1, down at 1..2
        std::vector<double> before;  ///< the values that undo returns to
    };
    static std::vector<double> valuesAt(const Animation& animation, const render::Knob& knob, double time);

    Clock& clock_;
    std::function<void(const render::Knob&)> changed_;
    const scene::Scene* scene_ = nullptr;
    std::vector<render::Knob> knobs_;
    render::KeptValues kept_;
    std::vector<std::optional<Animation>> animations_;  ///< of each knob
};

}  // namespace glibra::view
