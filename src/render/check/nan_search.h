#pragma once
// Finds the draws that put NaN or infinity into a picture, or that lose primitives because of such positions.
// It draws the frame again into floats, up to a chosen draw, and bisects until one draw is left.

#include <glibra/render.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/program.h"
#include "render/load/programs.h"
#include "render/scene_renderer.h"

namespace glibra::render {

// ---- Positions
// Finds the draws that place vertices at NaN or infinity. The picture does not show them: a primitive with
// such a vertex is not drawn.

/// A draw with vertices whose gl_Position is not finite when it leaves the last stage before rasterisation.
struct LostPrimitives {
    const plan::PlannedDraw* draw = nullptr;
    std::string kind;                 ///< "triangles", "lines" or "points"
    std::uint64_t lost = 0, all = 0;  ///< primitives with such a vertex, and all primitives
};

class PositionSearch {
  public:
    explicit PositionSearch(const gpu::Context& context) : capabilities_(&context.capabilities()) {}

    /// Draws one frame and captures the positions of every draw; the results are in drawing order. The stages
    /// before rasterisation run three times per draw, and each program is linked once more when it is first
    /// used. Draws with more than 2^25 vertices are examined up to that number; a program that does not link
    /// without its fragment stage is skipped. Use one search with one renderer only.
    std::vector<LostPrimitives> search(SceneRenderer& renderer, double time, Stats& stats);

  private:
    const gpu::Program* programFor(const BuiltProgram& built);
    std::optional<LostPrimitives> look(FrameDrawer& drawer, const plan::PlannedDraw& draw);

    const gpu::Capabilities* capabilities_;
    std::map<const BuiltProgram*, std::optional<gpu::Program>> programs_;
};

// ---- Pictures

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
