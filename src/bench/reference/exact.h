#pragma once
// Vectors and matrices of numbers with 100 decimal digits: the references for float and double.

#include <array>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace glibra::bench {

using Exact =
    boost::multiprecision::number<boost::multiprecision::cpp_dec_float<100>, boost::multiprecision::et_off>;

using ExactVector = std::array<Exact, 3>;
using ExactMatrix = std::array<ExactVector, 3>;  ///< columns

/// Exact: every double is a decimal fraction, with fewer than 100 digits in the ranges used here.
inline ExactVector exact(const glm::dvec3& v) {
    return {Exact(v.x), Exact(v.y), Exact(v.z)};
}
inline ExactMatrix exact(const glm::dmat3& m) {
    return {exact(m[0]), exact(m[1]), exact(m[2])};
}

inline ExactVector operator+(const ExactVector& a, const ExactVector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline ExactVector operator*(const Exact& s, const ExactVector& v) {
    return {s * v[0], s * v[1], s * v[2]};
}
inline ExactVector operator*(const ExactMatrix& m, const ExactVector& v) {
    return v[0] * m[0] + v[1] * m[1] + v[2] * m[2];
}
inline Exact dot(const ExactVector& a, const ExactVector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline ExactVector cross(const ExactVector& a, const ExactVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Exact length(const ExactVector& v) {
    return sqrt(dot(v, v));
}

/// |a - b|, rounded once at the end.
inline double distance(const ExactVector& a, const glm::dvec3& b) {
    return static_cast<double>(length(a - exact(b)));
}
/// The angle between the two vectors in degrees. Neither is 0.
inline double degreesBetween(const ExactVector& a, const glm::dvec3& b) {
    const ExactVector other = exact(b);
    const Exact sine = length(cross(a, other)), cosine = dot(a, other);
    return static_cast<double>(atan2(sine, cosine) * 180 / boost::math::constants::pi<Exact>());
}

}  // namespace glibra::bench
