#pragma once
// Renders shots with one context, one after another. What they share is made once. While one is drawn,
// another thread prepares the parts of the next ones that need no GL.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "gpu/context/context.h"
#include "render/load/shared_parts.h"
#include "render/scene_renderer.h"
#include "render/stats.h"
#include "suite/run/background.h"
#include "suite/run/verdict.h"
#include "suite/suite.h"

namespace glibra::suite {

/// The largest number of shots that are prepared while one is drawn.
inline constexpr std::size_t kShotsAhead = 2;

class ShotRenderer {
  public:
    /// The context must outlive the object. `ofAll` is that of RunOptions. `awaits` is called before the
    /// renderer waits for another shot that is being prepared, and with null after it.
    explicit ShotRenderer(gpu::Context& context, Shot ofAll = {},
                          std::function<void(const Shot*)> awaits = {})
        : context_(context), ofAll_(std::move(ofAll)), awaits_(std::move(awaits)), shared_(std::in_place) {}

    /// Errors are in the result, including draw-E05 if memory runs out. `coming`, at most kShotsAhead shots,
    /// are prepared meanwhile for the calls that render them. The picture does not depend on them.
    Rendering render(const Shot& shot, std::span<const Shot* const> coming = {});
    /// Forgets everything, so that the next shot is loaded anew.
    void forget();

  private:
    /// What a shot is loaded from. Shots with the same source differ only in their time.
    struct Source {
        std::filesystem::path script;
        RenderOptions options;  ///< without the time
        friend bool operator==(const Source&, const Source&) = default;
    };
    struct Loaded {
        Source source;
        std::unique_ptr<render::Stats> stats;  ///< the renderer writes to it while it exists
        render::SceneRenderer renderer;
        Diagnostics diagnostics;
        /// The picture drawn last, if other times may give the same.
        std::optional<image::Image> picture;
        render::Moment moment;  ///< the moment of that picture
    };
    struct Preparation {
        const Shot* shot = nullptr;
        Source source;
        std::unique_ptr<render::Stats> stats;
        std::uint64_t job = 0;                       ///< of background_
        std::optional<render::PreparedScene> scene;  ///< once the job is done; nothing if that failed
    };

    [[nodiscard]] Source sourceOf(const Shot& shot) const;
    Rendering tryRender(const Shot& shot, std::span<const Shot* const> coming);
    Diagnostics load(const Source& source, std::span<const Shot* const> coming);
    void prepare(std::span<const Shot* const> coming, const Source& current);
    void beginPreparation(const Shot& shot, Source source);
    void dropPreparationsFrom(std::size_t first);
    Result<image::Image> draw(double time);

    gpu::Context& context_;
    Shot ofAll_;
    std::function<void(const Shot*)> awaits_;
    std::optional<render::SharedParts> shared_;
    std::optional<Loaded> loaded_;
    std::deque<Preparation> preparations_;  ///< in the order of the shots
    Background background_;  ///< last, because it must end before the objects that it works on are destroyed
};

}  // namespace glibra::suite
