#pragma once
// Shots to pictures with one context, one after another. What they have in common is made once; while one is
// drawn, what the next ones need and needs no GL is made on a thread of its own.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "gpu/context.h"
#include "render/scene_renderer.h"
#include "render/shared_parts.h"
#include "render/stats.h"
#include "suite/run/background.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"

namespace glibra::suite {

/// Shots that are prepared beside the one that is drawn, at most.
inline constexpr std::size_t kShotsAhead = 2;

class ShotRenderer {
  public:
    /// The context must outlive it. `skip`: RunOptions::skip.
    ShotRenderer(gpu::Context& context, bool skip) : context_(context), skip_(skip), shared_(std::in_place) {}

    /// Errors are in the result, running out of memory among them (draw-E05). `coming`, at most kShotsAhead
    /// shots, are prepared meanwhile for the calls that are for them; the picture is the same with them or
    /// without.
    Rendering render(const Shot& shot, std::span<const Shot* const> coming = {});
    /// The next shot is made from nothing.
    void forget();

  private:
    /// What a shot is loaded from; shots that have it in common differ in their time alone.
    struct Source {
        std::filesystem::path script;
        RenderOptions options;  ///< without the time
        friend bool operator==(const Source&, const Source&) = default;
    };
    struct Loaded {
        Source source;
        std::unique_ptr<render::Stats> stats;  ///< the renderer writes to it as long as it lives
        render::SceneRenderer renderer;
        Diagnostics diagnostics;
        /// The picture drawn last, if others may be the same.
        std::optional<image::Image> picture;
        render::Moment moment;  ///< of that picture
    };
    struct Preparation {
        Source source;
        std::unique_ptr<render::Stats> stats;
        std::uint64_t job = 0;                       ///< of background_
        std::optional<render::PreparedScene> scene;  ///< once the job is done; nothing if that failed
    };

    [[nodiscard]] Source sourceOf(const Shot& shot) const;
    Rendering tryRender(const Shot& shot, std::span<const Shot* const> coming);
    Diagnostics load(const Source& source, std::span<const Shot* const> coming);
    void prepare(std::span<const Shot* const> coming, const Source& current);
    void beginPreparation(Source source);
    void dropPreparationsFrom(std::size_t first);
    Result<image::Image> draw(double time);

    gpu::Context& context_;
    bool skip_;
    std::optional<render::SharedParts> shared_;
    std::optional<Loaded> loaded_;
    std::deque<Preparation> preparations_;  ///< in the order of the shots
    Background background_;                 ///< last: it has to end before what it works on goes
};

}  // namespace glibra::suite
