#include "bench/reference/depth_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glibra::bench {
namespace {

constexpr std::array kKinds{
    DepthKind{.name = "16 bit", .format = GL_DEPTH_COMPONENT16, .bits = 16},
    DepthKind{.name = "24 bit", .format = GL_DEPTH_COMPONENT24, .bits = 24},
    DepthKind{.name = "32 bit float", .format = GL_DEPTH_COMPONENT32F, .bits = 24, .isFloat = true},
    DepthKind{.name = "32 bit float, reversed, -1..1",
              .format = GL_DEPTH_COMPONENT32F,
              .bits = 24,
              .isFloat = true,
              .isReversed = true},
    DepthKind{.name = "32 bit float, reversed, 0..1",
              .format = GL_DEPTH_COMPONENT32F,
              .bits = 24,
              .isFloat = true,
              .isReversed = true,
              .isZeroToOne = true},
};

constexpr int kMantissa = 24;  // bits of the floats that coordinates are kept in

/// The spacing at `value` of floats with `bits` bits of mantissa.
double spacing(double value, int bits) {
    int exponent = 0;
    (void)std::frexp(std::max(value, static_cast<double>(std::numeric_limits<float>::min())), &exponent);
    return std::ldexp(1., exponent - bits);
}

}  // namespace

std::span<const DepthKind> depthKinds() {
    return kKinds;
}

double depthStep(const DepthKind& kind, double near, double far, double z) {
    double step = 1 / (std::ldexp(1., kind.bits) - 1);
    if (kind.isFloat) {
        const double usual = far * (z - near) / (z * (far - near));
        step = spacing(kind.isReversed ? near * (far - z) / (z * (far - near)) : usual, kind.bits);
        if (!kind.isZeroToOne) step = std::max(step, spacing(std::abs(2 * usual - 1), kind.bits) / 2);
    }
    const double perDistance = step * (far - near) / (far * near);
    const double inBuffer = perDistance * z < 1 ? perDistance * z * z / (1 - perDistance * z) : far;
    const double gap = inBuffer + spacing(z, kMantissa);
    return z + gap <= far ? gap : kNaN;
}

}  // namespace glibra::bench
