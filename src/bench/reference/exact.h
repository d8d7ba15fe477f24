#pragma once
// Exact numbers: with 100 decimal digits, and the steps of depth buffers.

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "gpu/format/pixel_format.h"

namespace glibra::bench {

// Vectors and matrices of numbers with 100 decimal digits: the references for float and double.

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

// Depth formats and mappings, and the gap that one step of each stands for.

/// How depth is stored and mapped.
struct DepthKind {
    std::string_view name;
    gpu::TexelFormat format = gpu::TexelFormat::depth24;
    int bits = 24;             ///< for floats, the mantissa including its leading one
    bool isReversed = false;   ///< 1 at the near plane, 0 at the far plane
    bool isZeroToOne = false;  ///< normalised depth runs from 0 to 1 (glClipControl, GL 4.5), not from -1
    [[nodiscard]] bool isFloat() const { return format == gpu::TexelFormat::depth32f; }
};
inline constexpr std::array kDepthKinds{
    DepthKind{"16 bit", gpu::TexelFormat::depth16, 16},
    DepthKind{"24 bit", gpu::TexelFormat::depth24, 24},
    DepthKind{"32 bit float", gpu::TexelFormat::depth32f, 24},
    DepthKind{"32 bit float, reversed, -1..1", gpu::TexelFormat::depth32f, 24, true},
    DepthKind{"32 bit float, reversed, 0..1", gpu::TexelFormat::depth32f, 24, true, true},
};
/// The spacing at `value` of floats with `bits` bits of mantissa.
inline double spacing(double value, int bits) {
    int exponent = 0;
    (void)std::frexp(std::max(value, static_cast<double>(std::numeric_limits<float>::min())), &exponent);
    return std::ldexp(1., exponent - bits);
}

/// The gap beyond distance z (eye space, near <= z <= far) that one step of the depth buffer stands for, in
/// the unit of z; NaN if it would reach beyond the far plane. With k = step (f - n) / (f n) it is k z^2 / (1
/// - k z), from depth f (z - n) / (z (f - n)); E. Lapidous and G. Jiao, Optimal Depth Buffer for Low-Cost
/// Graphics Hardware, 1999. The step is 1 / (2^b - 1) or the spacing of floats at that depth. Depths in -1..1
/// are floats themselves: their spacing, halved by the mapping to 0..1, is the step where it is larger.
inline double depthStep(const DepthKind& kind, double near, double far, double z) {
    constexpr int kMantissa = 24;  // bits of the floats that coordinates are kept in
    double step = 1 / (std::ldexp(1., kind.bits) - 1);
    if (kind.isFloat()) {
        const double usual = far * (z - near) / (z * (far - near));
        step = spacing(kind.isReversed ? near * (far - z) / (z * (far - near)) : usual, kind.bits);
        if (!kind.isZeroToOne) step = std::max(step, spacing(std::abs(2 * usual - 1), kind.bits) / 2);
    }
    const double perDistance = step * (far - near) / (far * near);
    const double inBuffer = perDistance * z < 1 ? perDistance * z * z / (1 - perDistance * z) : far;
    const double gap = inBuffer + spacing(z, kMantissa);
    return z + gap <= far ? gap : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace glibra::bench
