#pragma once
// The time limits of a worker that draws one shot while it judges another. Each of the two has the time of
// its shot, so that a shot that takes too long is late itself and makes no other shot late.

#include <chrono>
#include <functional>
#include <map>
#include <optional>

#include "suite/run/run_messages.h"
#include "suite/suite.h"

namespace glibra::suite {

/// The clocks of one piece. Messages of a worker that has been taken over may be any; the number of those
/// that restart a clock is limited per shot.
class ShotClocks {
  public:
    using Clock = std::chrono::steady_clock;

    /// `limitOf` gives the seconds of a shot; 0: no limit. It must outlive the object.
    explicit ShotClocks(const std::function<double(const ShotReference&)>& limitOf) : limitOf_(&limitOf) {}

    void hear(const Begins& begins, Clock::time_point now);
    void hear(const Phase& phase, Clock::time_point now);
    void hear(const Done& done);

    /// The seconds until the first of the running clocks has reached its limit, at least a millisecond; 0: no
    /// limit. Nothing if no clock runs.
    [[nodiscard]] std::optional<double> left(Clock::time_point now) const;
    /// The shot whose clock reaches its limit first; nothing if none runs with a limit.
    [[nodiscard]] std::optional<ShotReference> latest() const;
    /// The shot that is being judged.
    [[nodiscard]] std::optional<ShotReference> judged() const;

  private:
    struct Running {
        ShotReference shot;
        Clock::time_point since;
    };
    /// False if the shot has restarted clocks too often.
    bool mayRestart(const ShotReference& shot);
    [[nodiscard]] std::optional<Clock::time_point> endOf(const std::optional<Running>& running) const;

    const std::function<double(const ShotReference&)>* limitOf_;
    std::optional<Running> drawing_, judging_;
    std::map<ShotReference, int> restarts_;
};

}  // namespace glibra::suite
