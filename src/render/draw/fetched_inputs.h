#pragma once
// Vertex data that the vertex stage fetches from a texture, because it has too few attributes for the corners
// of a patch or primitive (glsl::ExpandedGeometry).

#include <array>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/texture.h"
#include "gpu/state/state_tracker.h"
#include "plan/frame_plan.h"
#include "render/load/device_meshes.h"
#include "render/load/programs.h"

namespace glibra::render {

class FetchedInputs {
  public:
    /// Data of the mesh, or the same value for all vertices.
    using Source = std::variant<std::array<double, 4>, const DeviceMesh::Attribute*>;

    /// Binds the texture for a draw with the program that is bound. `sources`: in the order of
    /// ExpandedGeometry::fetched. Errors: those of gpu::Texture::create; nothing is bound then.
    Diagnostics bind(const gpu::Capabilities& capabilities, gpu::BindingTracker& bindings,
                     const BuiltProgram& built, const plan::PlannedDraw& draw, const DeviceMesh& mesh,
                     const std::vector<Source>& sources);

  private:
    struct Made {
        std::vector<Source> sources;
        std::optional<gpu::Texture> texture;
    };
    std::map<const plan::PlannedDraw*, Made> made_;
};

}  // namespace glibra::render
