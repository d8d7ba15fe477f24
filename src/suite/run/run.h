#pragma once
// Draws the shots of suites in worker processes and judges them there, so that pictures never travel through
// a pipe. A shot that crashes, hangs or runs out of memory affects only itself.

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "suite/results/results.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::suite {

// Divides a run into pieces for its workers.

/// Returns pieces of consecutive items of 0..count-1. Long pieces are first, so that a worker can overlap
/// drawing one shot with judging another and reuse what it loaded. Single items are last, so that all workers
/// end together. One worker gets pieces as long as possible. `joins(i)`: item i may be in the same piece as
/// item i - 1.
std::vector<std::vector<std::size_t>> planPieces(std::size_t count, int workers,
                                                 const std::function<bool(std::size_t)>& joins);

// The time limits of a worker that draws one shot while it judges another. Each of the two has the time of
// its shot, so that a shot that takes too long is late itself and makes no other shot late.

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

// Finds the shot that ended a worker which drew one shot and prepared the next ones.

/// All of these shots are drawn again, each by itself. The one that ends its worker again is to blame. If
/// none does, it is the one that was being drawn, because an end without a reason must be reported.
class Suspicions {
  public:
    /// `ended` is the result of `drawn` if no shot ends its worker again. If it is forgiven (Shot::retries),
    /// the result is that of `drawn` by itself, which is flaky if it passes. A shot is under at most one
    /// suspicion.
    void add(const ShotReference& drawn, std::vector<ShotReference> prepared, ShotResult ended,
             bool isForgiven = false);
    /// True for a shot that must be drawn by itself from now on.
    [[nodiscard]] bool isUnder(const ShotReference& shot) const;
    /// Takes the result of a shot that was drawn by itself, and returns the results that are final now: none
    /// if the shot depends on others.
    std::vector<ShotResult> settle(const ShotReference& shot, const ShotResult& result);

  private:
    struct Suspicion {
        ShotReference drawn;
        std::vector<ShotReference> open;  ///< prepared shots that have not been drawn by themselves yet
        ShotResult ended;
        std::optional<ShotResult> result;  ///< of `drawn`, drawn by itself
        bool isOtherGuilty = false;        ///< a prepared shot ended its worker
        bool isForgiven = false;
    };
    static bool concerns(const Suspicion& suspicion, const ShotReference& shot);

    std::vector<Suspicion> suspicions_;
};

struct RunEvents {
    /// Called for each shot as it is done, in any order.
    std::function<void(const ShotResult&)> done;
    /// Called before a worker draws a shot.
    std::function<void(const ShotReference&)> begins;
    /// Called regularly. Once it returns true, the run ends with the shots that are done.
    std::function<bool()> stop;
};

struct RunEnd {
    std::string driver;       ///< GL_RENDERER and GL_VERSION; empty if no shot was drawn
    Diagnostics diagnostics;  ///< of the run: hash lists, no driver (gpu-E01)
    bool noDriver = false;
    bool stopped = false;
};

/// Call it before any thread or GL context exists.
RunEnd runShots(std::span<const Suite> suites, std::span<const ShotReference> shots,
                const RunOptions& options, const RunEvents& events);

}  // namespace glibra::suite
