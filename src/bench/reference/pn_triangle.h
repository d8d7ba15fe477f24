#pragma once
// A curved PN triangle in double: the reference for tessellation shaders.

#include <array>
#include <glm/vec3.hpp>

namespace glibra::bench {

/// The cubic Bezier triangle through three corners with normals (A. Vlachos et al., Curved PN Triangles,
/// 2001), evaluated by de Casteljau's algorithm.
class PnTriangle {
  public:
    PnTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals);

    /// The point at barycentric coordinates, which add up to 1.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& barycentric) const;
    /// The distance of a point from the surface, searched by Gauss-Newton steps from the given coordinates.
    /// The surface continues beyond its edges.
    [[nodiscard]] double distance(const glm::dvec3& point, const glm::dvec3& start) const;

  private:
    struct Near {
        glm::dvec3 position{0};
        std::array<glm::dvec3, 3>
            last{};  ///< the last triangle of the algorithm: its plane is tangent to the surface
    };
    [[nodiscard]] Near deCasteljau(const glm::dvec3& barycentric) const;

    std::array<glm::dvec3, 10> points_{};  ///< b(i,j,k), i falling, then j falling
};

}  // namespace glibra::bench
