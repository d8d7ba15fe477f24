#pragma once
// Which draws place vertices at NaN or infinity. Nothing of the picture shows it: what such a vertex belongs
// to is not drawn.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/program.h"
#include "render/programs.h"
#include "render/scene_renderer.h"

namespace glibra::render {

/// A draw with vertices of which gl_Position has a component that is no finite number, when it leaves the
/// last stage before rasterisation.
struct LostPrimitives {
    const plan::PlannedDraw* draw = nullptr;
    std::string kind;                 ///< "triangles", "lines" or "points"
    std::uint64_t lost = 0, all = 0;  ///< how many of them have such a vertex
};

class PositionSearch {
  public:
    explicit PositionSearch(const gpu::Context& context) : capabilities_(&context.capabilities()) {}

    /// Draws one frame and has every draw's positions captured beside it: the stages before rasterisation run
    /// three times for each draw, and each program is linked once more when it is first met. In the order of
    /// drawing. Of a draw that becomes more than 2^25 vertices the first are looked at; a program that cannot
    /// be linked without its fragment stage is left out. Always with the same renderer.
    std::vector<LostPrimitives> search(SceneRenderer& renderer, double time, Stats& stats);

  private:
    const gpu::Program* programFor(const BuiltProgram& built);
    std::optional<LostPrimitives> look(FrameDrawer& drawer, const plan::PlannedDraw& draw);

    const gpu::Capabilities* capabilities_;
    std::map<const BuiltProgram*, std::optional<gpu::Program>> programs_;
};

}  // namespace glibra::render
