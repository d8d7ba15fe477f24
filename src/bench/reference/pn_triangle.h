#pragma once
// A curved PN triangle in double.

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace glibra::bench {

/// The cubic Bezier triangle through three corners with normals (A. Vlachos et al., Curved PN Triangles,
/// 2001), evaluated by de Casteljau's algorithm.
class PnTriangle {
  public:
    PnTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals) {
        const auto towards = [&](std::size_t from, std::size_t to) {
            const glm::dvec3 step = corners[to] - corners[from];
            return corners[from] + (step - glm::dot(step, normals[from]) * normals[from]) / 3.;
        };
        const auto set = [&](int i, int j, const glm::dvec3& point) { points_[placeOf(3, i, j)] = point; };
        set(3, 0, corners[0]);
        set(0, 3, corners[1]);
        set(0, 0, corners[2]);
        set(2, 1, towards(0, 1));
        set(1, 2, towards(1, 0));
        set(0, 2, towards(1, 2));
        set(0, 1, towards(2, 1));
        set(1, 0, towards(2, 0));
        set(2, 0, towards(0, 2));
        const glm::dvec3 edges =
            (towards(0, 1) + towards(1, 0) + towards(1, 2) + towards(2, 1) + towards(2, 0) + towards(0, 2)) /
            6.;
        const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.;
        set(1, 1, edges + (edges - middle) / 2.);
    }

    /// The point at barycentric coordinates, which add up to 1.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& barycentric) const {
        return deCasteljau(barycentric).position;
    }

    /// The distance of a point from the surface, searched by Gauss-Newton steps from the given coordinates.
    /// The surface continues beyond its edges.
    [[nodiscard]] double distance(const glm::dvec3& point, const glm::dvec3& start) const {
        constexpr int kSteps = 6;
        constexpr double kDegree = 3;
        glm::dvec3 where = start;
        for (int step = 0; step < kSteps; ++step) {
            const Near near = deCasteljau(where);
            const glm::dvec3 along = kDegree * (near.last[0] - near.last[2]),
                             across = kDegree * (near.last[1] - near.last[2]), miss = point - near.position;
            const double aa = glm::dot(along, along), bb = glm::dot(across, across),
                         ab = glm::dot(along, across);
            const double a = glm::dot(along, miss), b = glm::dot(across, miss);
            const double determinant = aa * bb - ab * ab;
            where.x += (bb * a - ab * b) / determinant;
            where.y += (aa * b - ab * a) / determinant;
            where.z = 1 - where.x - where.y;
        }
        return glm::length(point - at(where));
    }

  private:
    struct Near {
        glm::dvec3 position{0};
        std::array<glm::dvec3, 3>
            last{};  ///< the last triangle of the algorithm: its plane is tangent to the surface
    };

    /// The index of b(i,j,k) with i + j + k = degree among all, i falling, then j falling.
    static std::size_t placeOf(int degree, int i, int j) {
        const auto row = static_cast<std::size_t>(degree - i);
        return row * (row + 1) / 2 + row - static_cast<std::size_t>(j);
    }

    [[nodiscard]] Near deCasteljau(const glm::dvec3& barycentric) const {
        std::array<glm::dvec3, 10> points = points_;
        for (int degree = 2; degree > 0; --degree)
            // In rising order, each result overwrites a point that is no longer needed.
            for (int i = degree; i >= 0; --i)
                for (int j = degree - i; j >= 0; --j)
                    points[placeOf(degree, i, j)] = barycentric.x * points[placeOf(degree + 1, i + 1, j)] +
                                                    barycentric.y * points[placeOf(degree + 1, i, j + 1)] +
                                                    barycentric.z * points[placeOf(degree + 1, i, j)];
        return {barycentric.x * points[0] + barycentric.y * points[1] + barycentric.z * points[2],
                {points[0], points[1], points[2]}};
    }

    std::array<glm::dvec3, 10> points_{};  ///< b(i,j,k), i falling, then j falling
};

}  // namespace glibra::bench
