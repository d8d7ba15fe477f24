#pragma once
// The work of one worker process. It keeps its GL context from piece to piece, and overlaps drawing a shot
// with judging the shots before it and preparing the shots after it.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"
#include "gpu/context/context.h"
#include "suite/golden/golden_store.h"
#include "suite/run/run_options.h"
#include "suite/run/shot_renderer.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"

namespace glibra::suite {

/// What all workers of a run share. It outlives them.
struct RunPlan {
    std::span<const Suite> suites;
    std::vector<GoldenStore> goldens;  ///< one per suite; empty if the run only renders
    const RunOptions& options;
    std::vector<std::vector<ShotReference>> pieces;
    int jobs = 1;
    /// Drawings of a shot that ended their worker, or were late, and that `retries` forgive: the shot is
    /// drawn again, alone.
    struct Ended {
        int times = 0;
        ShotResult first;  ///< of the first of them
    };
    std::map<ShotReference, Ended> ended{};

    [[nodiscard]] const Shot& shotOf(const ShotReference& reference) const {
        return suites[reference.suite].shots[reference.shot];
    }
};

class ShotWorker {
  public:
    explicit ShotWorker(const RunPlan& plan) : plan_(plan) {}

    /// Does a piece and sends a message per step. The answer is empty, or says why there is no driver.
    std::string operator()(std::size_t piece, const base::Step& step);

  private:
    /// Opens the context. Returns nothing, or why there is none. `awaits`: see ShotRenderer.
    std::string openContext();
    /// `coming` are the shots that follow.
    Attempt attempt(const ShotReference& reference, std::span<const Shot* const> coming);
    /// The verdict; nothing if the shot has to be rendered once more, which `again` then holds.
    std::optional<Judged> judge(const ShotReference& reference, const Attempt& drawn,
                                const Attempt* again) const;
    /// How often a shot that fails may still be drawn again.
    [[nodiscard]] int retriesLeft(const ShotReference& reference) const;
    /// Writes the picture of a run that only renders.
    Judged keep(const ShotReference& reference, const Attempt& attempt) const;

    const RunPlan& plan_;
    std::optional<gpu::Context> context_;
    std::string driver_, driverKey_;
    std::function<void(const Shot*)> awaits_;  ///< during a piece: tells the parent what drawing waits for
    std::vector<ShotJudge> judges_;
    std::optional<ShotRenderer> renderer_;  ///< after the context, because it must be destroyed first
};

}  // namespace glibra::suite
