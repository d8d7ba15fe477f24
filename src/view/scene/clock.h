#pragma once
// The time of a scene: plays, pauses, steps, is set and runs at any speed. It never looks at a real clock;
// who owns it says how much time went by.

namespace glibra::view {

class Clock {
  public:
    /// Seconds since the scene was loaded, as shaders see it.
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] bool isPlaying() const { return playing_; }
    [[nodiscard]] double speed() const { return speed_; }

    void play(bool on) { playing_ = on; }
    /// Seconds of the scene a second; negative runs backwards. Limited to -1000..1000.
    void setSpeed(double speed);
    /// Not below 0.
    void setTime(double seconds);
    /// Pauses and goes on by one frame of 1/30 second, times the speed; `frames` may be negative.
    void step(int frames);
    /// `seconds` of real time went by. True if the scene's time changed.
    bool advance(double seconds);

    static constexpr double kFrameSeconds = 1.0 / 30;

  private:
    double time_ = 0;
    double speed_ = 1;
    bool playing_ = true;
};

}  // namespace glibra::view
