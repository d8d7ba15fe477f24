#pragma once
// The error of a mesh: its distance from a surface, its normals, outline and volume. Lengths are in units of
// the radius; the meshes of solids have a radius of .7, so that no vertex is exact only because its numbers
// are round.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::bench {

inline constexpr double kSolidRadius = .7;  ///< radius of the meshes

/// The surface point closest to a point.
struct Foot {
    double distance = 0;
    glm::dvec3 normal{0};   ///< outward, unit length
    bool hasNormal = true;  ///< false at the apex of the cone
};
/// `face` is the outward normal of the triangle that holds the point: it distinguishes a cap from the side.
using FootOn = Foot (*)(const glm::dvec3& point, const glm::dvec3& face);
/// On the unit sphere.
Foot footOnSphere(const glm::dvec3& point, const glm::dvec3& face);

/// The distance of a mesh from a surface, measured at a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle in degrees between the interpolated normal and the surface's
    double faceNormal = 0;  ///< the same for the normals of the triangles
};
MeshError meshError(const geometry::Mesh& mesh, FootOn foot);
/// The same for a mesh of the unit sphere scaled by kSolidRadius.
MeshError sphereError(const geometry::Mesh& mesh);

/// The volume of a closed mesh in cubed radii; positive if triangles are counter-clockwise seen from outside.
double signedVolume(const geometry::Mesh& mesh);
/// Bytes of vertices and indices together.
double meshBytes(const geometry::Mesh& mesh);

inline constexpr double kOutlineRadius = 512;  ///< pixels of a radius where outlines are compared
/// The largest distance between the outlines of mesh and solid in three views without perspective: the
/// largest difference of the extents of their convex hulls in 360 directions per view. `extent` is the
/// largest dot(p, direction) over the solid (support function), for a unit direction.
double outlineError(const geometry::Mesh& mesh, const std::function<double(const glm::dvec3&)>& extent);

/// 0..180 degrees; accurate for small angles too.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b);

/// Three components of an attribute of every vertex, in double; missing components are 0. Empty if the mesh
/// has no such attribute.
std::vector<glm::dvec3> vectorsOf(const geometry::Mesh& mesh, std::string_view name);

/// Interpolates linearly, as the pipeline does.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    std::array<glm::dvec3, 3> positions{}, normals{}, texCoords{};
    glm::dvec3 faceNormal{0};  ///< unit length

    [[nodiscard]] glm::dvec3 position(const glm::dvec3& weights) const { return mixed(positions, weights); }
    /// Normalised.
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& weights) const {
        return glm::normalize(mixed(normals, weights));
    }
    [[nodiscard]] glm::dvec2 texCoord(const glm::dvec3& weights) const { return mixed(texCoords, weights); }

  private:
    static glm::dvec3 mixed(const std::array<glm::dvec3, 3>& of, const glm::dvec3& weights) {
        return weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
    }
};

/// Calls visit(const Triangle&, const glm::dvec3& weights) at (cells + 1)(cells + 2) / 2 points of every
/// triangle that has an area, including its corners and edges. The mesh has normals and texture coordinates.
template <class Visit>
void forEachTriangle(const geometry::Mesh& mesh, int cells, const Visit& visit) {
    const std::vector<glm::dvec3> positions = vectorsOf(mesh, geometry::kPosition),
                                  normals = vectorsOf(mesh, geometry::kNormal),
                                  texCoords = vectorsOf(mesh, geometry::kTexCoord);
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.indices[first + i];
            triangle.vertices[i] = vertex;
            triangle.positions[i] = positions[vertex];
            triangle.normals[i] = normals[vertex];
            triangle.texCoords[i] = texCoords[vertex];
        }
        const glm::dvec3 across = glm::cross(triangle.positions[1] - triangle.positions[0],
                                             triangle.positions[2] - triangle.positions[0]);
        const double area = glm::length(across);
        if (!(area > 0)) continue;
        triangle.faceNormal = across / area;
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; i + j <= cells; ++j)
                visit(triangle, glm::dvec3(i, j, cells - i - j) / static_cast<double>(cells));
    }
}

}  // namespace glibra::bench
