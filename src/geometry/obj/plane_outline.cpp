#include "geometry/obj/plane_outline.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace glibra::geometry {
namespace {

glm::dvec3 wide(const Triple& point) {
    return {point[0], point[1], point[2]};
}

/// The sign of a sum whose terms are exact in double: the sum grows as an expansion of parts that do not
/// overlap, the last of which has its sign (J. Shewchuk, Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates, 1997).
int signOfSum(const std::array<double, 6>& terms) {
    std::array<double, 6> parts{};
    std::size_t count = 0;
    for (const double term : terms) {
        double carried = term;
        for (std::size_t i = 0; i < count; ++i) {
            const double sum = carried + parts[i];
            const double virtualPart = sum - carried;
            parts[i] = (carried - (sum - virtualPart)) + (parts[i] - virtualPart);
            carried = sum;
        }
        parts[count++] = carried;
    }
    while (count > 0 && parts[count - 1] == 0) --count;
    return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1;
}

}  // namespace

int nearestAxis(const glm::dvec3& vector) {
    // Polygons in a plane at 45 degrees are all seen along the same axis, whatever rounding says.
    constexpr double kClearly = 1.01;
    int axis = 2;
    for (const int other : {1, 0})
        if (std::abs(vector[other]) > kClearly * std::abs(vector[axis])) axis = other;
    return axis;
}

int orientation(PlanePoint a, PlanePoint b, PlanePoint c) {
    const double ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
    const double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
    constexpr double kError = 4e-16;  // (3 + 16 e) e with e = 2^-53, in the same paper
    const double error = kError * (std::abs(left) + std::abs(right));
    if (left - right > error) return 1;
    if (right - left > error) return -1;
    // Multiplied out, because products of two floats are exact in double.
    return signOfSum({ax * by, -(ay * bx), bx * cy, -(by * cx), cx * ay, -(cy * ax)});
}

std::vector<PlanePoint> planeOutline(std::span<const Triple> polygon) {
    const std::size_t count = polygon.size();
    glm::dvec3 area(0), turns(0);
    const glm::dvec3 origin = wide(polygon[0]);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 a = wide(polygon[i]), b = wide(polygon[(i + 1) % count]);
        area += glm::cross(a - origin, b - origin);
        turns += glm::abs(glm::cross(b - a, wide(polygon[(i + 2) % count]) - b));
    }
    constexpr double kRounding = 1e-6;
    const bool hasArea = glm::length(area) > kRounding * glm::length(turns);
    const int axis = nearestAxis(hasArea ? area : turns);
    const auto x = static_cast<std::size_t>((axis + 1) % 3), y = static_cast<std::size_t>((axis + 2) % 3);
    std::vector<PlanePoint> points;
    points.reserve(count);
    for (const Triple& each : polygon) points.push_back({each[x], each[y]});
    return points;
}

}  // namespace glibra::geometry
