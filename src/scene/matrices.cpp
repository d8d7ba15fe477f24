#include "scene/matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace glibra::scene {
namespace {

double largestElement(const glm::dmat3& matrix) {
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(matrix[i][j]));
    return largest;
}

/// Returns matrix * factor. If a float cannot hold the largest element of that product, the matrix is divided
/// by its largest element instead.
glm::dmat3 timesWithinFloats(const glm::dmat3& matrix, double factor) {
    const double largest = largestElement(matrix);
    const double product = largest * factor;
    const bool fits =
        product >= std::numeric_limits<float>::min() && product <= std::numeric_limits<float>::max();
    if (largest == 0 || fits) return matrix * factor;
    return matrix / largest;
}

}  // namespace

glm::dmat3 normalMatrix(const glm::dmat4& modelView) {
    // Dividing by a power of two first keeps the products of very small and very large elements in range,
    // and changes no bit of them.
    glm::dmat3 linear(modelView);
    const double largest = largestElement(linear);
    if (!(largest > 0) || !std::isfinite(largest)) return glm::dmat3(0.0);
    const double unit = std::ldexp(1.0, std::ilogb(largest));
    linear /= unit;
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    if (isSingular(linear)) return timesWithinFloats(cofactors, unit * unit);
    const double determinant = glm::dot(linear[0], cofactors[0]);
    return timesWithinFloats(cofactors / determinant, 1 / unit);
}

bool isFinite(const glm::dmat4& matrix) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!(std::abs(matrix[i][j]) <= std::numeric_limits<float>::max())) return false;
    return true;
}

}  // namespace glibra::scene
