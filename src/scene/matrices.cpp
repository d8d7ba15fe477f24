#include "scene/matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace glibra::scene {
namespace {

constexpr double kSmallestDeterminant = 1e-14;

double length(const glm::dvec3& v) {
    return std::hypot(v.x, v.y, v.z);
}
double length(const glm::dvec4& v) {
    return std::hypot(std::hypot(v.x, v.y, v.z), v.w);
}

/// Sine of (90 * quarters + rest) degrees, for |rest| <= 45.
double sineOf(int quarters, double rest) {
    const double radians = rest * (glm::pi<double>() / 180);
    switch (quarters & 3) {
        case 0:
            return std::sin(radians);
        case 1:
            return std::cos(radians);
        case 2:
            return -std::sin(radians);
        default:
            break;
    }
    return -std::cos(radians);
}

double sineOfTurned(double degrees, int quarters) {
    const double turned = std::fmod(degrees, 360);
    const double nearest = std::round(turned / 90);
    return sineOf(static_cast<int>(nearest) + quarters, turned - 90 * nearest) + 0.0;  // never -0
}

template <class Matrix>
bool isSingularMatrix(const Matrix& matrix) {
    // Columns are scaled to length one first, so that the result does not depend on their units.
    Matrix scaled = matrix;
    for (int i = 0; i < Matrix::length(); ++i) {
        const double size = length(matrix[i]);
        if (!(size > 0) || !std::isfinite(size)) return true;
        scaled[i] = matrix[i] / size;
    }
    return !(std::abs(glm::determinant(scaled)) > kSmallestDeterminant);
}

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

double sineOfDegrees(double degrees) {
    return sineOfTurned(degrees, 0);
}
double cosineOfDegrees(double degrees) {
    return sineOfTurned(degrees, 1);
}

glm::dmat4 translation(const glm::dvec3& offset) {
    glm::dmat4 matrix(1.0);
    matrix[3] = glm::dvec4(offset, 1.0);
    return matrix;
}

glm::dmat4 scaling(const glm::dvec3& factors) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) matrix[i][i] = factors[i];
    return matrix;
}

glm::dmat4 rotation(double degrees, const glm::dvec3& axis) {
    const double size = length(axis);
    glm::dmat4 matrix(1.0);
    if (!(size > 0) || !std::isfinite(size)) return matrix;
    const glm::dvec3 a = axis / size;
    const double c = cosineOfDegrees(degrees);
    const double s = sineOfDegrees(degrees);
    const glm::dmat3 cross(0, a.z, -a.y, -a.z, 0, a.x, a.y, -a.x, 0);  // in column order
    // Rodrigues: c I + s [a]x + (1 - c) a a^T
    const glm::dmat3 turned = c * glm::dmat3(1.0) + s * cross + (1 - c) * glm::outerProduct(a, a);
    for (int i = 0; i < 3; ++i) matrix[i] = glm::dvec4(turned[i], 0.0);
    return matrix;
}

std::optional<glm::dmat4> viewingMatrix(const glm::dvec3& eye, const glm::dvec3& centre,
                                        const glm::dvec3& up) {
    constexpr double kParallel = 1e-12;
    const glm::dvec3 view = centre - eye;
    const double distance = length(view);
    const double upLength = length(up);
    if (!(distance > 0) || !(upLength > 0) || !std::isfinite(distance) || !std::isfinite(upLength))
        return std::nullopt;
    const glm::dvec3 forward = view / distance;
    const glm::dvec3 across = glm::cross(forward, up / upLength);
    if (!(length(across) > kParallel)) return std::nullopt;
    const glm::dvec3 right = across / length(across);
    const glm::dvec3 top = glm::cross(right, forward);
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 3; ++i) matrix[i] = glm::dvec4(right[i], top[i], -forward[i], 0);
    matrix[3] = glm::dvec4(-glm::dot(right, eye), -glm::dot(top, eye), glm::dot(forward, eye), 1);
    return matrix;
}

bool isSingular(const glm::dmat3& matrix) {
    return isSingularMatrix(matrix);
}
bool isSingular(const glm::dmat4& matrix) {
    return isSingularMatrix(matrix);
}

glm::dmat4 inverseOrZero(const glm::dmat4& matrix) {
    if (isSingular(matrix)) return glm::dmat4(0.0);
    // Columns are scaled to length one first, so that the determinant stays in range for very small and very
    // large scales.
    glm::dmat4 scaled = matrix;
    glm::dvec4 sizes(1.0);
    for (int i = 0; i < 4; ++i) {
        sizes[i] = length(matrix[i]);
        scaled[i] = matrix[i] / sizes[i];
    }
    glm::dmat4 inverse = glm::inverse(scaled);
    for (int i = 0; i < 4; ++i)
        inverse[i] /= sizes;  // row i of the inverse belongs to column i of the matrix
    return inverse;
}

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

MatrixFamily familyOf(const glm::dmat4& matrix) {
    MatrixFamily family;
    family.matrix = matrix;
    family.inverse = inverseOrZero(matrix);
    family.transpose = glm::transpose(matrix);
    family.inverseTranspose = glm::transpose(family.inverse);
    return family;
}

DrawMatrices drawMatrices(const glm::dmat4& modelView, const glm::dmat4& projection) {
    DrawMatrices matrices;
    matrices.modelView = familyOf(modelView);
    matrices.projection = familyOf(projection);
    matrices.modelViewProjection = familyOf(projection * modelView);
    matrices.normal = normalMatrix(modelView);
    return matrices;
}

bool isFinite(const glm::dmat4& matrix) {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            if (!(std::abs(matrix[i][j]) <= std::numeric_limits<float>::max())) return false;
    return true;
}

}  // namespace glibra::scene
