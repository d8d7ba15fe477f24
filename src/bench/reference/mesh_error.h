#pragma once
// The error of a mesh: its distance from a surface, its normals, outline and volume. Lengths are in units of
// the radius; the meshes of solids have a radius of .7, so that no vertex is exact only because its numbers
// are round.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
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
inline Foot footOnSphere(const glm::dvec3& p, const glm::dvec3& /*face*/) {
    const double length = glm::length(p);
    return {std::abs(length - 1), p / length};
}

/// 0..180 degrees; accurate for small angles too.
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

/// Three components of an attribute of every vertex, in double; missing components are 0. Empty if the mesh
/// has no such attribute.
inline std::vector<glm::dvec3> vectorsOf(const geometry::Mesh& mesh, std::string_view name) {
    const geometry::Attribute* attribute = mesh.attribute(name);
    if (!attribute) return {};
    const auto components = static_cast<std::size_t>(attribute->components);
    std::vector<glm::dvec3> vectors(attribute->values.size() / components);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t c = 0; c < components && c < 3; ++c)
            vectors[i][static_cast<glm::length_t>(c)] = attribute->values[i * components + c];
    return vectors;
}

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

/// The distance of a mesh from a surface, measured at a net of points on every triangle.
struct MeshError {
    double distance = 0;    ///< largest
    double normal = 0;      ///< largest angle in degrees between the interpolated normal and the surface's
    double faceNormal = 0;  ///< the same for the normals of the triangles
};
inline MeshError meshError(const geometry::Mesh& mesh, FootOn foot) {
    MeshError largest;
    forEachTriangle(mesh, 6, [&](const Triangle& triangle, const glm::dvec3& weights) {
        const Foot at = foot(triangle.position(weights) / kSolidRadius, triangle.faceNormal);
        largest.distance = std::max(largest.distance, at.distance);
        if (!at.hasNormal) return;
        largest.normal = std::max(largest.normal, angleBetween(triangle.normal(weights), at.normal));
        largest.faceNormal = std::max(largest.faceNormal, angleBetween(triangle.faceNormal, at.normal));
    });
    return largest;
}

/// The same for a mesh of the unit sphere scaled by kSolidRadius.
inline MeshError sphereError(const geometry::Mesh& mesh) {
    return meshError(mesh, footOnSphere);
}

/// The volume of a closed mesh in cubed radii; positive if triangles are counter-clockwise seen from outside.
inline double signedVolume(const geometry::Mesh& mesh) {
    const std::vector<glm::dvec3> p = vectorsOf(mesh, geometry::kPosition);
    double six = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        six += glm::dot(p[mesh.indices[i]], glm::cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
    return six / (6 * kSolidRadius * kSolidRadius * kSolidRadius);
}

/// Bytes of vertices and indices together.
inline double meshBytes(const geometry::Mesh& mesh) {
    std::size_t values = mesh.indices.size();
    for (const geometry::Attribute& each : mesh.attributes) values += each.values.size();
    return 4. * static_cast<double>(values);
}

inline constexpr double kOutlineRadius = 512;  ///< pixels of a radius where outlines are compared
/// The largest distance between the outlines of mesh and solid in three views without perspective: the
/// largest difference of the extents of their convex hulls in 360 directions per view. `extent` is the
/// largest dot(p, direction) over the solid (support function), for a unit direction.
inline double outlineError(const geometry::Mesh& mesh,
                           const std::function<double(const glm::dvec3&)>& extent) {
    constexpr int kDirections = 360;
    const std::vector<glm::dvec3> positions = vectorsOf(mesh, geometry::kPosition);
    const std::array<std::array<glm::dvec3, 2>, 3> views{{
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)},
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)},
        {glm::dvec3(.6, .48, .64), glm::dvec3(0, .8, -.6)},
    }};
    double largest = 0;
    for (const auto& [right, up] : views)
        for (int i = 0; i < kDirections; ++i) {
            // The golden section spreads the directions so that they meet slices at every phase.
            const double angle = 2 * std::numbers::pi * i * std::numbers::phi;
            const glm::dvec3 direction = std::cos(angle) * right + std::sin(angle) * up;
            double farthest = -1e300;
            for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::dot(p, direction));
            largest = std::max(largest, std::abs(farthest / kSolidRadius - extent(direction)));
        }
    return largest;
}

}  // namespace glibra::bench
