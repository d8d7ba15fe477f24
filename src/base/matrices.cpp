#include "base/matrices.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

namespace glibra::base {
namespace {

constexpr double kSmallestDeterminant = 1e-14;

double length(const glm::dvec2& v) {
    return std::hypot(v.x, v.y);
}
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

template <class Matrix>
Matrix inverseOrZeroOf(const Matrix& matrix) {
    if (isSingularMatrix(matrix)) return Matrix(0.0);
    // Columns are scaled to length one first, so that the determinant stays in range for very small and very
    // large scales.
    Matrix scaled = matrix;
    typename Matrix::col_type sizes(1.0);
    for (int i = 0; i < Matrix::length(); ++i) {
        sizes[i] = length(matrix[i]);
        scaled[i] = matrix[i] / sizes[i];
    }
    Matrix inverse = glm::inverse(scaled);
    for (int i = 0; i < Matrix::length(); ++i)
        inverse[i] /= sizes;  // row i of the inverse belongs to column i of the matrix
    return inverse;
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

glm::dmat4 perspectiveProjection(double degrees, double aspect, double near, double far) {
    const double half = degrees / 2;
    const double scale = cosineOfDegrees(half) / sineOfDegrees(half);
    glm::dmat4 matrix(0.0);
    matrix[0][0] = scale / aspect;
    matrix[1][1] = scale;
    matrix[2][2] = (near + far) / (near - far);
    matrix[2][3] = -1;
    matrix[3][2] = 2 * near * far / (near - far);
    return matrix;
}

glm::dmat4 boxProjection(double left, double right, double bottom, double top, double near, double far) {
    const double depth = far - near;
    glm::dmat4 matrix(0.0);
    matrix[0][0] = 2 / (right - left);
    matrix[1][1] = 2 / (top - bottom);
    matrix[2][2] = -2 / depth;
    matrix[3] = glm::dvec4(-(left + right) / (right - left), -(bottom + top) / (top - bottom),
                           -(near + far) / depth, 1);
    return matrix;
}

glm::dmat4 frustumProjection(double left, double right, double bottom, double top, double near, double far) {
    glm::dmat4 matrix(0.0);
    matrix[0][0] = 2 * near / (right - left);
    matrix[1][1] = 2 * near / (top - bottom);
    matrix[2] = glm::dvec4((right + left) / (right - left), (top + bottom) / (top - bottom),
                           (near + far) / (near - far), -1);
    matrix[3][2] = 2 * near * far / (near - far);
    return matrix;
}

bool isSingular(const glm::dmat2& matrix) {
    return isSingularMatrix(matrix);
}
bool isSingular(const glm::dmat3& matrix) {
    return isSingularMatrix(matrix);
}
bool isSingular(const glm::dmat4& matrix) {
    return isSingularMatrix(matrix);
}

glm::dmat2 inverseOrZero(const glm::dmat2& matrix) {
    return inverseOrZeroOf(matrix);
}
glm::dmat3 inverseOrZero(const glm::dmat3& matrix) {
    return inverseOrZeroOf(matrix);
}
glm::dmat4 inverseOrZero(const glm::dmat4& matrix) {
    return inverseOrZeroOf(matrix);
}

}  // namespace glibra::base
