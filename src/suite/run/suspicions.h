#pragma once
// Which shot ended a worker that drew one and prepared the next ones.

#include <optional>
#include <vector>

#include "suite/results/results.h"
#include "suite/run/run.h"

namespace glibra::suite {

/// All of them are drawn once more, each by itself; the one that ends its worker again is to blame. If none
/// does, the one that was being drawn is: an end without a reason is not passed over.
class Suspicions {
  public:
    /// `ended` is what is told of `drawn` if none does it again. A shot is under one suspicion at most.
    void add(const ShotReference& drawn, std::vector<ShotReference> prepared, ShotResult ended);
    /// True for a shot that is to be drawn by itself, now and later.
    [[nodiscard]] bool isUnder(const ShotReference& shot) const;
    /// What can be told now that the shot has come to this result: nothing if it depends on the others.
    std::vector<ShotResult> settle(const ShotReference& shot, const ShotResult& result);

  private:
    struct Suspicion {
        ShotReference drawn;
        std::vector<ShotReference> open;  ///< prepared ones that are still to be drawn by themselves
        ShotResult ended;
        std::optional<ShotResult> result;  ///< of `drawn`, by itself
        bool isOtherGuilty = false;        ///< a prepared one ended its worker by itself
    };
    static bool concerns(const Suspicion& suspicion, const ShotReference& shot);

    std::vector<Suspicion> suspicions_;
};

}  // namespace glibra::suite
