#pragma once
// Finds the shot that ended a worker which drew one shot and prepared the next ones.

#include <optional>
#include <vector>

#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

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

}  // namespace glibra::suite
