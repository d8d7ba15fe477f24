#pragma once
// Exact areas of triangles in pixels.

#include <array>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace glibra::bench {

/// Corners in pixels; (0, 0) is the upper left corner of the picture.
using FlatTriangle = std::array<glm::dvec2, 3>;

/// The share of each pixel, 0..1, that the triangles cover. They do not overlap. Each triangle is clipped in
/// double by the square of the pixel (I. Sutherland and G. Hodgman, Reentrant Polygon Clipping, 1974). Rows
/// from the top.
std::vector<double> coverage(std::span<const FlatTriangle> triangles, int width, int height);

}  // namespace glibra::bench
