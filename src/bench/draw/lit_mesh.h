#pragma once
// Lit pictures as the driver draws them: meshes lit in several ways, and highlights alone. Red is the
// intensity; green is 1 on the surface.

#include <glibra/result.h>

#include <glm/vec3.hpp>

#include "bench/reference/analytic_lighting.h"
#include "geometry/mesh.h"
#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/vertex_array.h"

namespace glibra::bench {

/// A picture shows a square of eye space; this is half its side.
inline constexpr double kSeen = 1.05;

enum class LightingMethod {
    perVertex,     ///< evaluated at the vertices; the intensity is interpolated
    interpolated,  ///< evaluated per fragment with the interpolated normal as it is
    renormalised,  ///< evaluated per fragment with the interpolated normal normalised
    analytic  ///< evaluated per fragment with the exact normal of the surface above the interpolated position
};

/// Ambient, diffuse and reflected light, for a mesh with "position" and "normal".
Result<gpu::Program> lightingProgram(const gpu::Capabilities& capabilities, LitSurface surface,
                                     LightingMethod method, const glm::dvec3& light, double exponent);

/// The highlight alone, on a unit sphere that fills the target; for drawWhole. Uniforms: uLight, uExponent.
Result<gpu::Program> highlightProgram(const gpu::Capabilities& capabilities, Highlight model);

/// A mesh on the device.
class LitMesh {
  public:
    static Result<LitMesh> create(const geometry::Mesh& mesh);
    /// Clears the target and draws with the depth test.
    void draw(const gpu::Program& program, const gpu::Target& target) const;
    [[nodiscard]] double bytes() const;

  private:
    LitMesh(gpu::Buffer positions, gpu::Buffer normals, gpu::Buffer indices, int count);
    gpu::Buffer positions_, normals_, indices_;
    gpu::VertexArray array_;
    int count_;
};

}  // namespace glibra::bench
