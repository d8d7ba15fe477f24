#include "budget/pixel_scale.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace glibra::budget {
namespace {

bool isFinite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

/// Returns the corners, in clip space, of the part of the box in front of the near plane z = -w: the box's
/// own corners there, and the points where its edges cross the plane.
std::vector<glm::dvec4> cornersInFront(const glm::dmat4& clipFromModel, const geometry::Extent& extent) {
    std::vector<glm::dvec4> all, front;
    for (unsigned i = 0; i < 8; ++i)
        all.push_back(clipFromModel * glm::dvec4((i & 1U) != 0 ? extent.high.x : extent.low.x,
                                                 (i & 2U) != 0 ? extent.high.y : extent.low.y,
                                                 (i & 4U) != 0 ? extent.high.z : extent.low.z, 1));
    const auto depth = [](const glm::dvec4& point) { return point.z + point.w; };
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (depth(all[i]) >= 0) front.push_back(all[i]);
        for (const std::size_t bit : {1U, 2U, 4U}) {
            const glm::dvec4 &a = all[i], &b = all[i | bit];
            if ((i & bit) == 0 && (depth(a) < 0) != (depth(b) < 0))
                front.push_back(a + (b - a) * (depth(a) / (depth(a) - depth(b))));
        }
    }
    return front;
}

/// Returns the norm of the matrix with these two rows: the root of the larger eigenvalue of the product with
/// its transpose.
double norm(const glm::dvec3& x, const glm::dvec3& y) {
    const double xx = glm::dot(x, x), yy = glm::dot(y, y), xy = glm::dot(x, y);
    return std::sqrt((xx + yy) / 2 + std::hypot((xx - yy) / 2, xy));
}

}  // namespace

std::optional<double> pixelsPerUnit(const glm::dmat4& clipFromModel, const geometry::Extent& extent,
                                    double width, double height) {
    if (!isFinite(clipFromModel)) return std::nullopt;
    const std::vector<glm::dvec4> corners = cornersInFront(clipFromModel, extent);
    if (corners.empty()) return 0;
    const glm::dmat4 rows = glm::transpose(clipFromModel);
    const glm::dvec3 alongX(rows[0]), alongY(rows[1]), alongW(rows[3]);

    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec4& each : corners) nearest = std::min(nearest, each.w);
    const double centreW = glm::dot(alongW, (extent.low + extent.high) * .5) + rows[3].w;
    nearest = std::max(nearest, centreW - extent.radius * glm::length(alongW));
    if (!(nearest > 0)) return std::nullopt;

    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const glm::dvec4& each : corners) {
        if (!(each.w > 0)) return std::nullopt;
        low = glm::min(low, glm::dvec2(each) / each.w);
        high = glm::max(high, glm::dvec2(each) / each.w);
    }
    low = glm::max(low, glm::dvec2(-kPictureMargin));
    high = glm::min(high, glm::dvec2(kPictureMargin));
    if (low.x > high.x || low.y > high.y) return 0;

    double largest = 0;
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y})
            largest = std::max(largest,
                               norm(width / 2 * (alongX - x * alongW), height / 2 * (alongY - y * alongW)));
    return largest / nearest;
}

}  // namespace glibra::budget
