#pragma once
// The surfaces that meshes approximate, written after language, 4, independently of the shapes' own code; and
// the distance of a mesh from them.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/mesh.h"
#include "scene/primitives.h"

namespace glibra::budget::test {

inline glm::dvec3 valueAt(const geometry::Mesh& mesh, std::string_view name, std::uint32_t vertex) {
    const geometry::Attribute& attribute = *mesh.attribute(name);
    glm::dvec3 value(0);
    for (int i = 0; i < std::min(3, attribute.components); ++i)
        value[i] =
            static_cast<double>(attribute.values[vertex * static_cast<std::size_t>(attribute.components) +
                                                 static_cast<std::size_t>(i)]);
    return value;
}

inline geometry::Mesh meshOf(glib::CommandId command, const std::vector<double>& numbers) {
    scene::Scene scene;
    scene.shapes.push_back({command, numbers, {}, nullptr});
    return *scene::makeMesh(scene, scene::ShapeIndex(0));
}

/// A point of a triangle. Place and texture coordinates are interpolated linearly, as the rasteriser does.
struct MeshPoint {
    glm::dvec3 place, texCoord;
    std::array<std::uint32_t, 3> corners;
    glm::dvec3 weights;
};

/// Calls `use` for a grid of points on every `stride`-th triangle.
inline void eachPoint(const geometry::Mesh& mesh, std::size_t stride,
                      const std::function<void(const MeshPoint&)>& use) {
    constexpr int kCuts = 8;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3 * stride) {
        const std::array<std::uint32_t, 3> corners{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        for (int a = 0; a <= kCuts; ++a)
            for (int b = 0; a + b <= kCuts; ++b) {
                MeshPoint point{{}, {}, corners, glm::dvec3(a, b, kCuts - a - b) / double(kCuts)};
                for (int c = 0; c < 3; ++c) {
                    const auto corner = corners[static_cast<std::size_t>(c)];
                    point.place += point.weights[c] * valueAt(mesh, geometry::kPosition, corner);
                    point.texCoord += point.weights[c] * valueAt(mesh, geometry::kTexCoord, corner);
                }
                use(point);
            }
    }
}

/// Returns the largest value of `distance` over points of the mesh.
inline double farthest(const geometry::Mesh& mesh, const std::function<double(const MeshPoint&)>& distance,
                       std::size_t stride = 1) {
    double most = 0;
    eachPoint(mesh, stride, [&](const MeshPoint& point) { most = std::max(most, distance(point)); });
    return most;
}

inline double turn(double part) {
    return 2 * std::numbers::pi * part;
}
/// The point of a sphere (language, 4.2).
inline glm::dvec3 spherePoint(double radius, double s, double t) {
    const double f = std::numbers::pi * (t - .5);
    return radius *
           glm::dvec3(-std::cos(turn(s)) * std::cos(f), std::sin(f), std::sin(turn(s)) * std::cos(f));
}
inline glm::dvec3 conePoint(double radius, double height, double s, double t, bool narrows) {
    const double r = narrows ? radius * (1 - t) : radius;
    return {-r * std::cos(turn(s)), height * t, r * std::sin(turn(s))};
}
inline glm::dvec3 torusPoint(double ring, double tube, double s, double t) {
    const double r = ring + tube * std::cos(turn(t));
    return {r * std::cos(turn(s)), r * std::sin(turn(s)), tube * std::sin(turn(t))};
}
inline double torusDistance(double ring, double tube, const glm::dvec3& p) {
    return std::abs(std::hypot(std::hypot(p.x, p.y) - ring, p.z) - tube);
}

}  // namespace glibra::budget::test
