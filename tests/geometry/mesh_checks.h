#pragma once
// Checks for every mesh of this room, which use only its arrays.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

using Indices = std::vector<std::uint32_t>;

inline constexpr double kPi = std::numbers::pi;

inline glm::dvec3 valueAt(const Mesh& mesh, std::string_view name, std::uint32_t vertex) {
    const Attribute* attribute = mesh.attribute(name);
    glm::dvec3 value(0);
    if (!attribute) return value;
    for (int c = 0; c < std::min(3, attribute->components); ++c)
        value[c] = attribute->values[std::size_t{vertex} * static_cast<std::size_t>(attribute->components) +
                                     static_cast<std::size_t>(c)];
    return value;
}
inline glm::dvec3 positionAt(const Mesh& mesh, std::uint32_t vertex) {
    return valueAt(mesh, kPosition, vertex);
}
inline glm::dvec3 normalAt(const Mesh& mesh, std::uint32_t vertex) {
    return valueAt(mesh, kNormal, vertex);
}
inline glm::dvec3 tangentAt(const Mesh& mesh, std::uint32_t vertex) {
    return valueAt(mesh, kTangent, vertex);
}
inline glm::dvec3 texCoordAt(const Mesh& mesh, std::uint32_t vertex) {
    return valueAt(mesh, kTexCoord, vertex);
}

inline Counts countsOf(const Mesh& mesh) {
    return {mesh.vertexCount(), mesh.indices.size() / static_cast<std::size_t>(verticesPerPrimitive(
                                                          mesh.topology, mesh.patchVertices))};
}

/// Returns counts that were computed by hand.
inline Counts stated(int vertices, int primitives) {
    return {static_cast<std::uint64_t>(vertices), static_cast<std::uint64_t>(primitives)};
}

/// Expects arrays of equal length, indices in range, finite numbers, unit normals and tangents at right
/// angles, and s and t in 0..1.
inline void expectSound(const Mesh& mesh, bool texCoordsInRange = true) {
    const std::size_t count = mesh.vertexCount();
    for (const Attribute& attribute : mesh.attributes) {
        EXPECT_EQ(attribute.values.size(), count * static_cast<std::size_t>(attribute.components))
            << attribute.name;
        EXPECT_TRUE(std::all_of(attribute.values.begin(), attribute.values.end(), [](float value) {
            return std::isfinite(value);
        })) << attribute.name;
    }
    EXPECT_TRUE(
        std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](auto index) { return index < count; }));
    double normalError = 0, tangentError = 0, angleError = 0, texCoordError = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        normalError = std::max(normalError, std::abs(glm::length(normalAt(mesh, i)) - 1));
        if (mesh.attribute(kTangent)) {
            tangentError = std::max(tangentError, std::abs(glm::length(tangentAt(mesh, i)) - 1));
            angleError = std::max(angleError, std::abs(glm::dot(tangentAt(mesh, i), normalAt(mesh, i))));
        }
        const glm::dvec3 st = texCoordAt(mesh, i);
        texCoordError = std::max({texCoordError, -st.x, -st.y, -st.z, st.x - 1, st.y - 1, st.z - 1});
    }
    EXPECT_LT(normalError, 2e-7);
    EXPECT_LT(tangentError, 2e-7);
    EXPECT_LT(angleError, 2e-7);
    if (texCoordsInRange) {
        EXPECT_LT(texCoordError, 1e-6);
    }
}

/// Calls use(a, b, c) with the vertices of each triangle in order.
template <class Use>
void forEachTriangle(const Mesh& mesh, Use use) {
    for (std::size_t i = 0; i + 3 <= mesh.indices.size(); i += 3)
        use(mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]);
}

/// The largest value of a function of places, at 45 places of each triangle; 0 if all are negative.
template <class Function>
double largestOnTriangles(const Mesh& mesh, Function function) {
    double largest = 0;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (int i = 0; i <= 8; ++i)
            for (int j = 0; i + j <= 8; ++j) {
                const glm::dvec3 place = (positionAt(mesh, a) * double(i) + positionAt(mesh, b) * double(j) +
                                          positionAt(mesh, c) * double(8 - i - j)) /
                                         8.;
                largest = std::max(largest, function(place));
            }
    });
    return largest;
}

/// Counts the triangles that have no area or are not counter-clockwise seen from the side of all their
/// normals.
inline std::size_t wronglyWound(const Mesh& mesh) {
    std::size_t wrong = 0;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = positionAt(mesh, a);
        const glm::dvec3 area = glm::cross(positionAt(mesh, b) - p, positionAt(mesh, c) - p);
        const bool right = glm::dot(area, normalAt(mesh, a)) > 0 && glm::dot(area, normalAt(mesh, b)) > 0 &&
                           glm::dot(area, normalAt(mesh, c)) > 0;
        wrong += right ? 0 : 1;
    });
    return wrong;
}

using PositionBits = std::array<std::uint32_t, 3>;

/// Numbers the vertices so that those with equal bits have the same number.
inline std::vector<std::uint32_t> weldedByBits(const Mesh& mesh) {
    std::map<PositionBits, std::uint32_t> known;
    std::vector<std::uint32_t> welded;
    const Attribute* position = mesh.attribute(kPosition);
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
        PositionBits bits;
        for (std::size_t c = 0; c < 3; ++c)
            bits[c] = std::bit_cast<std::uint32_t>(position->values[3 * i + c]);
        welded.push_back(known.emplace(bits, static_cast<std::uint32_t>(known.size())).first->second);
    }
    return welded;
}

/// Counts the edges, by the bits of their ends, that do not have exactly one triangle on each side.
inline std::size_t openEdges(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            const std::uint32_t p = welded[from], q = welded[to];
            auto& use = uses[std::minmax(p, q)];
            ++(p < q ? use.first : use.second);
        }
    });
    return static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), [](const auto& edge) {
        return edge.second != std::pair{1, 1} || edge.first.first == edge.first.second;
    }));
}

/// Computes the volume by the divergence theorem; positive if triangles are counter-clockwise from outside.
inline double volume(const Mesh& mesh) {
    double sum = 0;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        sum += glm::dot(positionAt(mesh, a), glm::cross(positionAt(mesh, b), positionAt(mesh, c))) / 6;
    });
    return sum;
}

/// The smallest cosine, over all triangles, between the direction in which the position moves with growing t
/// (from the triangle's texture coordinates) and the mean tangent, and between that of s and cross(tangent,
/// normal). Each of the two may be off by the slope of a facet and the skewness of the texture.
struct FrameAgreement {
    double t = 1, s = 1;
};
inline FrameAgreement frameAgreement(const Mesh& mesh) {
    FrameAgreement agreement;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = positionAt(mesh, a), st = texCoordAt(mesh, a);
        const glm::dvec3 e1 = positionAt(mesh, b) - p, e2 = positionAt(mesh, c) - p;
        const glm::dvec3 d1 = texCoordAt(mesh, b) - st, d2 = texCoordAt(mesh, c) - st;
        const double determinant = d1.x * d2.y - d2.x * d1.y;
        ASSERT_NE(determinant, 0);
        const glm::dvec3 alongS = (d2.y * e1 - d1.y * e2) / determinant;
        const glm::dvec3 alongT = (d1.x * e2 - d2.x * e1) / determinant;
        const glm::dvec3 tangent = tangentAt(mesh, a) + tangentAt(mesh, b) + tangentAt(mesh, c);
        const glm::dvec3 normal = normalAt(mesh, a) + normalAt(mesh, b) + normalAt(mesh, c);
        agreement.t = std::min(agreement.t, glm::dot(glm::normalize(alongT), glm::normalize(tangent)));
        agreement.s = std::min(agreement.s,
                               glm::dot(glm::normalize(alongS), glm::normalize(glm::cross(tangent, normal))));
    });
    return agreement;
}

inline void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    EXPECT_LT(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

/// Returns the vertex nearest to a place.
inline std::uint32_t nearestVertex(const Mesh& mesh, const glm::dvec3& place) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < mesh.vertexCount(); ++i)
        if (glm::distance(positionAt(mesh, i), place) < glm::distance(positionAt(mesh, best), place))
            best = i;
    return best;
}

}  // namespace glibra::geometry
