#pragma once
// The work of one worker process: it keeps its GL context from piece to piece and overlaps drawing one shot
// with judging the one before.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "render/scene_renderer.h"
#include "render/stats.h"
#include "render/workers.h"
#include "suite/golden_store.h"
#include "suite/run_messages.h"
#include "suite/verdict.h"

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
    struct Loaded {
        std::filesystem::path script;
        RenderOptions options;
        std::unique_ptr<render::Stats> stats;  ///< the renderer writes to it as long as it lives
        render::SceneRenderer renderer;
        Diagnostics diagnostics;
        /// The picture drawn last, if others may be the same.
        std::optional<image::Image> picture;
        render::Moment moment;  ///< of that picture
    };

    /// Empty if there is a context.
    std::string openContext();
    Rendering render(const Shot& shot);
    Result<image::Image> draw(double time);
    /// The next shot is made from nothing.
    void forget();
    Rendering tryRender(const Shot& shot);
    Attempt attempt(const ShotReference& reference);
    Judged keep(const ShotReference& reference, const Attempt& attempt) const;
    [[nodiscard]] const Shot& shotOf(const ShotReference& reference) const;

    const RunPlan& plan_;
    std::optional<gpu::Context> context_;
    std::string driver_;
    std::vector<ShotJudge> judges_;
    // After the context: they have to go first.
    render::SharedParts shared_;
    std::optional<Loaded> loaded_;
};

}  // namespace glibra::suite
