#pragma once
// Finds the draws that put NaN or infinity into a picture, or that lose primitives because of such positions.
// It draws the frame again into floats, up to a chosen draw, and bisects until one draw is left.

#include <glibra/render.h>

#include <filesystem>
#include <memory>

#include "render/check/position_search.h"
#include "render/scene_renderer.h"

namespace glibra::render {

class NanSearch {
  public:
    /// Loads the scene again with a float window. Errors are those of SceneRenderer::load; warnings and notes
    /// of the first loading are not repeated.
    static Result<NanSearch> load(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options);

    /// Reports draw-W06 at the scene line of each draw that leaves NaN or infinity in a pixel, of the window
    /// or of a float texture, that was finite before it, in drawing order; the eighth message counts the
    /// rest. Reports draw-W09 likewise at each draw with NaN or infinity in gl_Position. Under `strict` both
    /// are errors. If everything is finite, the search costs two frames, a readback of each float target and
    /// a PositionSearch. Each draw-W06 costs about log2(draws) more frames.
    Diagnostics at(double time);

  private:
    NanSearch(const gpu::Context& context, std::unique_ptr<Stats> stats, SceneRenderer renderer, bool strict)
        : stats_(std::move(stats)), renderer_(std::move(renderer)), positions_(context), strict_(strict) {}
    std::unique_ptr<Stats> stats_;  ///< the renderer counts into it while it exists
    SceneRenderer renderer_;
    PositionSearch positions_;
    bool strict_;
};

}  // namespace glibra::render
