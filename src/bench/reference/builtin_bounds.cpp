#include "bench/reference/builtin_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glibra::bench::bounds {
namespace {

constexpr long double kRounding = 0x1p-24L;  ///< relative error of one correctly rounded operation

long double exponentialAllowed(long double exponent, long double result) {
    return (3 + 2 * std::fabs(exponent)) * unitInLastPlace(result);
}

/// The error at x, if `result` is the exact result.
long double logarithmAllowed(long double x, long double result) {
    return x >= .5L && x <= 2 ? 0x1p-21L : 3 * unitInLastPlace(result);
}

/// sqrt(x) is 1 / inversesqrt(x): 2 ULP of the latter, at most 4 roundings each, then the division.
long double rootAllowed(long double value) {
    return 4 * kRounding * value + 2.5L * unitInLastPlace(value);
}

/// (exp(x) +- exp(-x)) / 2.
long double hyperbolicAllowed(long double x) {
    const long double up = std::exp(x), down = std::exp(-x);
    return (exponentialAllowed(x, up) + exponentialAllowed(x, down)) / 2 +
           kRounding * std::fabs(up + down) / 2;
}

}  // namespace

long double none(const Arguments&, const Values&, int) {
    return 0;
}

long double exponential(const Arguments& x, const Values& y, int) {
    return exponentialAllowed(x[0], y[0]);
}

long double logarithm(const Arguments& x, const Values& y, int) {
    return logarithmAllowed(x[0], y[0]);
}

/// pow(x, y) is exp2(y * log2(x)).
long double power(const Arguments& x, const Values& y, int) {
    const long double logarithm = std::log2(x[0]);
    const long double exponent = x[4] * logarithm;
    const long double shift =
        std::fabs(x[4]) * logarithmAllowed(x[0], logarithm) + .5L * unitInLastPlace(exponent);
    return exponentialAllowed(exponent, y[0]) + std::numbers::ln2_v<long double> * shift * y[0];
}

long double root(const Arguments&, const Values& y, int) {
    return rootAllowed(y[0]);
}

long double hyperbolic(const Arguments& x, const Values&, int) {
    return hyperbolicAllowed(x[0]);
}

long double hyperbolicTangent(const Arguments& x, const Values& y, int) {
    const long double s = std::fabs(std::sinh(x[0])), c = std::cosh(x[0]);
    return hyperbolicAllowed(x[0]) * (1 + s / c) / c + 2.5L * unitInLastPlace(y[0]);
}

/// The square root halves the relative error of the sum of three squares: at most three roundings.
long double length(const Arguments&, const Values& y, int) {
    return 1.5L * kRounding * y[0] + rootAllowed(y[0]);
}
long double distance(const Arguments& x, const Values& y, int i) {
    return kRounding * y[0] + length(x, y, i);
}

/// v / length(v).
long double normalized(const Arguments& x, const Values& y, int i) {
    const Values of{std::hypot(std::hypot(x[0], x[1]), x[2])};
    const long double component = y[static_cast<std::size_t>(i)];
    return std::fabs(component) * length(x, of, 0) / of[0] + 2.5L * unitInLastPlace(component);
}

long double dot(const Arguments& x, const Values&, int) {
    long double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += std::fabs(x[i] * x[i + 4]);
    return 4 * kRounding * sum;
}

long double cross(const Arguments& x, const Values& y, int i) {
    const auto j = static_cast<std::size_t>((i + 1) % 3), k = static_cast<std::size_t>((i + 2) % 3);
    return kRounding * (std::fabs(x[j] * x[k + 4]) + std::fabs(x[k] * x[j + 4]) +
                        std::fabs(y[static_cast<std::size_t>(i)]));
}

/// I - 2 dot(N, I) N.
long double reflected(const Arguments& x, const Values& y, int i) {
    long double scalar = 0, sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        scalar += x[k] * x[k + 4];
        sum += std::fabs(x[k] * x[k + 4]);
    }
    const auto at = static_cast<std::size_t>(i);
    return 2 * std::fabs(x[at + 4]) * kRounding * (3 * sum + 2 * std::fabs(scalar)) +
           kRounding * std::fabs(y[at]);
}

/// The columns of the matrix are a.xy and a.zw.
long double product(const Arguments& x, const Values&, int i) {
    const auto row = static_cast<std::size_t>(i);
    return 2 * kRounding * (std::fabs(x[row] * x[4]) + std::fabs(x[row + 2] * x[5]));
}

/// x (1 - t) + y t.
long double mixture(const Arguments& x, const Values& y, int) {
    return kRounding * (2 * std::fabs(x[0] * (1 - x[4])) + std::fabs(x[1] * x[4]) + std::fabs(y[0]));
}

/// Two differences and their quotient, then t t (3 - 2 t).
long double smoothStep(const Arguments& x, const Values& y, int) {
    const long double t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.0L, 1.0L);
    return 6 * t * (1 - t) * 7 * kRounding * t + 3 * kRounding * y[0];
}

/// x - y floor(x / y): two roundings, if floor is right.
long double modulus(const Arguments& x, const Values& y, int) {
    return kRounding * (std::fabs(x[4] * std::floor(x[0] / x[4])) + std::fabs(y[0]));
}

/// pi / 180 x: the factor and the product are rounded.
long double angle(const Arguments&, const Values& y, int) {
    return 2 * kRounding * std::fabs(y[0]);
}

}  // namespace glibra::bench::bounds
