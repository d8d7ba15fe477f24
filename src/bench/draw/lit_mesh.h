#pragma once
// Lit pictures as the driver draws them: of meshes by several ways to light them, and of highlights alone.
// Red is the intensity, green 1 where the surface is.

#include <glibra/result.h>

#include <glm/vec3.hpp>

#include "bench/reference/analytic_lighting.h"
#include "geometry/mesh.h"
#include "gpu/buffer.h"
#include "gpu/capabilities.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/vertex_array.h"

namespace glibra::bench {

/// Half the side of the square of eye space that a picture shows.
inline constexpr double kSeen = 1.05;

enum class LightingMethod {
    perVertex,     ///< evaluated at the vertices, the intensity is interpolated
    interpolated,  ///< evaluated at the fragments with the interpolated normal as it is
    renormalised,  ///< with the interpolated normal made a unit vector
    analytic       ///< with the surface's own normal above the interpolated position
};

/// Ambient, diffuse and the reflection's highlight, from a mesh with "position" and "normal".
Result<gpu::Program> lightingProgram(const gpu::Capabilities& capabilities, LitSurface surface,
                                     LightingMethod method, const glm::dvec3& light, double exponent);

/// The highlight alone on the unit sphere that fills the target; for drawWhole. Uniforms: uLight, uExponent.
Result<gpu::Program> highlightProgram(const gpu::Capabilities& capabilities, Highlight model);

/// A mesh on the device.
class LitMesh {
  public:
    static Result<LitMesh> create(const geometry::Mesh& mesh);
    /// Clears the target and draws, with depth test.
    void draw(const gpu::Program& program, const gpu::Target& target) const;
    [[nodiscard]] double bytes() const;

  private:
    LitMesh(gpu::Buffer positions, gpu::Buffer normals, gpu::Buffer indices, int count);
    gpu::Buffer positions_, normals_, indices_;
    gpu::VertexArray array_;
    int count_;
};

}  // namespace glibra::bench
