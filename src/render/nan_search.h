#pragma once
// Which draws put NaN or infinity into a picture, or lose what they draw by such positions. The frame is
// drawn again up to this draw and that, into floats, and what is between two pictures is halved until one
// draw is left.

#include <glibra/render.h>

#include <filesystem>
#include <memory>

#include "render/position_search.h"
#include "render/scene_renderer.h"

namespace glibra::render {

class NanSearch {
  public:
    /// Loads the scene once more, with a window of floats. Errors are those of SceneRenderer::load; what the
    /// scene's own loading has already said is not said again.
    static Result<NanSearch> load(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options);

    /// draw-W06 at the scene line of each draw that leaves NaN or infinity in a pixel of the window, or of a
    /// float texture that was finite before it, in the order of drawing; the last one counts the rest beyond
    /// eight. draw-W09 likewise at each draw with NaN or infinity in gl_Position. Under `strict` they are
    /// errors. Nothing if all are finite: that costs two frames, a readback of each float target, and what
    /// PositionSearch does beside them. Each draw of a draw-W06 costs about log2(draws) frames more.
    Diagnostics at(double time);

  private:
    NanSearch(const gpu::Context& context, std::unique_ptr<Stats> stats, SceneRenderer renderer, bool strict)
        : stats_(std::move(stats)), renderer_(std::move(renderer)), positions_(context), strict_(strict) {}
    std::unique_ptr<Stats> stats_;  ///< the renderer counts into it as long as it lives
    SceneRenderer renderer_;
    PositionSearch positions_;
    bool strict_;
};

}  // namespace glibra::render
