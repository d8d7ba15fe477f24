#pragma once
// Points spread over every triangle of a mesh, with the values that the pipeline interpolates there.

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::bench {

/// Three components of an attribute of every vertex, in double; missing components are 0.
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

inline std::vector<glm::dvec3> positionsOf(const geometry::Mesh& mesh) {
    return vectorsOf(mesh, geometry::kPosition);
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
    const std::vector<glm::dvec3> positions = positionsOf(mesh), normals = vectorsOf(mesh, geometry::kNormal),
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

/// 0..180 degrees; accurate for small angles too.
inline double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace glibra::bench
