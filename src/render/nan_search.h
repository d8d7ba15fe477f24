#pragma once
// Which draws put NaN or infinity into a picture. The frame is drawn again up to this draw and that, into
// floats, and what is between two pictures is halved until one draw is left.

#include <glibra/render.h>

#include <filesystem>
#include <memory>

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
    /// eight. Under `strict` they are errors. Nothing if all pixels are finite: that costs one frame and a
    /// readback of each float target. Each draw that is named costs about log2(draws) frames more.
    Diagnostics at(double time);

  private:
    NanSearch(std::unique_ptr<Stats> stats, SceneRenderer renderer, bool strict)
        : stats_(std::move(stats)), renderer_(std::move(renderer)), strict_(strict) {}
    std::unique_ptr<Stats> stats_;  ///< the renderer counts into it as long as it lives
    SceneRenderer renderer_;
    bool strict_;
};

}  // namespace glibra::render
