#include "geometry/frame.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace glibra::geometry {

glm::dvec2 unitTurn(std::int64_t i, std::int64_t n) {
    assert(n >= 1 && i >= 0 && i <= n);
    i %= n;
    const std::int64_t octant = 8 * i / n;
    const std::int64_t rest = 8 * i - octant * n;
    // In odd octants the angle is measured back from their end, so it stays within 0 .. pi/4.
    const std::int64_t part = octant % 2 == 0 ? rest : n - rest;
    const double angle = std::numbers::pi / 4 * static_cast<double>(part) / static_cast<double>(n);
    // At pi/4 itself cos and sin differ in the last bit, which would show where octants meet.
    const double c = part == n ? std::sqrt(.5) : std::cos(angle), s = part == n ? c : std::sin(angle);
    glm::dvec2 point = octant % 4 == 1 || octant % 4 == 2 ? glm::dvec2{s, c} : glm::dvec2{c, s};
    if (octant >= 2 && octant <= 5) point.x = -point.x;
    if (octant >= 4) point.y = -point.y;
    return point + 0.0;  // -0 becomes 0
}

std::vector<glm::dvec2> unitCircle(int n) {
    std::vector<glm::dvec2> circle;
    circle.reserve(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i < n; ++i) circle.push_back(unitTurn(i, n));
    circle.push_back(circle.front());
    return circle;
}

glm::dvec3 fallbackTangent(const glm::dvec3& normal) {
    const glm::dvec3 n = unitOr(normal, {0, 0, 0});
    const double level = std::hypot(n.x, n.z);
    if (level > 0) return {-n.x / level * n.y, level, -n.z / level * n.y};
    if (n.y > 0) return {0, 0, -1};
    if (n.y < 0) return {0, 0, 1};
    return {0, 1, 0};
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return otherwise;
    const glm::dvec3 scaled = v / largest;
    const glm::dvec3 unit =
        scaled / std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
    return std::isfinite(unit.x + unit.y + unit.z) ? unit : otherwise;
}

}  // namespace glibra::geometry
