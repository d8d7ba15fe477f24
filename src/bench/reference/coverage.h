#pragma once
// Exact shares of pixels that triangles cover.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace glibra::bench {

/// Corners in pixels; (0, 0) is the upper left corner of the picture.
using FlatTriangle = std::array<glm::dvec2, 3>;

using Polygon = std::vector<glm::dvec2>;

/// The part on one side of a line along an axis: coordinate >= border, or <= border if `isUpper`.
inline Polygon cut(const Polygon& polygon, int axis, double border, bool isUpper) {
    Polygon kept;
    const auto depth = [&](const glm::dvec2& point) {
        return isUpper ? border - point[axis] : point[axis] - border;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = depth(from), b = depth(to);
        if (a >= 0) kept.push_back(from);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(from + (to - from) * (a / (a - b)));
    }
    return kept;
}

inline double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

inline int limitedPixel(double value, int most) {
    return static_cast<int>(std::clamp(value, 0., static_cast<double>(most)));
}

/// The share of each pixel, 0..1, that the triangles cover. They do not overlap. Each triangle is clipped in
/// double by the square of the pixel (I. Sutherland and G. Hodgman, Reentrant Polygon Clipping, 1974). Rows
/// from the top.
inline std::vector<double> coverage(std::span<const FlatTriangle> triangles, int width, int height) {
    std::vector<double> shares(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.);
    for (const FlatTriangle& triangle : triangles) {
        const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
        const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        const Polygon whole(triangle.begin(), triangle.end());
        for (int y = limitedPixel(top, height); y < limitedPixel(std::ceil(bottom), height); ++y) {
            const Polygon row = cut(cut(whole, 1, y, false), 1, y + 1, true);
            for (int x = limitedPixel(left, width); x < limitedPixel(std::ceil(right), width); ++x)
                shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)] += area(cut(cut(row, 0, x, false), 0, x + 1, true));
        }
    }
    return shares;
}

}  // namespace glibra::bench
