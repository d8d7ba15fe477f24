#pragma once
// Finds the draws that place vertices at NaN or infinity. The picture does not show them: a primitive with
// such a vertex is not drawn.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "gpu/object/program.h"
#include "render/load/programs.h"
#include "render/scene_renderer.h"

namespace glibra::render {

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

}  // namespace glibra::render
