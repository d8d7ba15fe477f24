#pragma once
// The work of one worker process: it keeps its GL context from piece to piece and overlaps drawing one shot
// with judging those before and preparing those after.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "render/workers.h"
#include "suite/golden/golden_store.h"
#include "suite/run/run_messages.h"
#include "suite/run/shot_renderer.h"
#include "suite/run/verdict.h"

namespace glibra::suite {

/// What all workers of a run know; it outlives them.
struct RunPlan {
    std::span<const Suite> suites;
    std::vector<GoldenStore> goldens;  ///< one a suite; empty if the run only renders
    const RunOptions& options;
    std::vector<std::vector<ShotReference>> pieces;
    int jobs = 1;
};

class ShotWorker {
  public:
    explicit ShotWorker(const RunPlan& plan) : plan_(plan) {}

    /// Does a piece, telling each step. The answer is empty, or says why there is no driver.
    std::string operator()(std::size_t piece, const render::Step& step);

  private:
    /// Empty if there is a context.
    std::string openContext();
    /// `coming` are the shots that follow.
    Attempt attempt(const ShotReference& reference, std::span<const Shot* const> coming);
    Judged keep(const ShotReference& reference, const Attempt& attempt) const;
    [[nodiscard]] const Shot& shotOf(const ShotReference& reference) const;

    const RunPlan& plan_;
    std::optional<gpu::Context> context_;
    std::string driver_;
    std::vector<ShotJudge> judges_;
    std::optional<ShotRenderer> renderer_;  ///< after the context: it has to go first
};

}  // namespace glibra::suite
