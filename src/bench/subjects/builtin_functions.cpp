#include "bench/subjects/builtins.h"

#include <math.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glibra::bench {

// The errors that GLSL 4.60, section 4.7.1, allows the built-in functions: absolute, for component i of the
// exact result y of the arguments x. Functions that the section defines by an equation inherit the errors of
// its operations, added up to first order. For BuiltinFunction::allowed.
namespace bounds {
namespace {

/// `halves` / 2 units in the last place.
template <int halves>
long double ulps(const Arguments&, const Values& y, int i) {
    return halves * .5L * unitInLastPlace(y[static_cast<std::size_t>(i)]);
}

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
}  // namespace
}  // namespace bounds

namespace {

/// A number in 0 <= u < 1 computed from the two arguments (finaliser of MurmurHash3 by Austin Appleby).
double uniform(std::uint32_t index, std::uint32_t slot) {
    std::uint64_t h = (std::uint64_t{index} << 8 | slot) + 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDULL;
    h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53ULL;
    h ^= h >> 33;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

float within(const ArgumentRange& range, double u) {
    const auto at = [&](double t) {
        const double value = range.byMagnitude ? range.low * std::pow(range.high / range.low, t)
                                               : std::lerp(range.low, range.high, t);
        return static_cast<float>(std::clamp(value, range.low, range.high));
    };
    if (!range.bothSigns) return at(u);
    return u < .5 ? -at(1 - 2 * u) : at(2 * u - 1);
}

using A = Arguments;
using V = Values;

constexpr std::string_view kOpen = "open";

ArgumentRange upTo(double high) {
    return {.low = 0, .high = high, .bothSigns = true};
}
ArgumentRange between(double low, double high) {
    return {.low = low, .high = high};
}
ArgumentRange magnitudes(double low, double high) {
    return {.low = low, .high = high, .byMagnitude = true};
}
ArgumentRange signedMagnitudes(double low, double high) {
    return {.low = low, .high = high, .byMagnitude = true, .bothSigns = true};
}

std::vector<ArgumentSweep> angles() {
    return {{std::numbers::pi / 4, "|x| to pi/4", upTo(std::numbers::pi / 4)},
            {std::numbers::pi, "|x| to pi", upTo(std::numbers::pi)},
            {31.4, "|x| to 10 pi", upTo(31.4)},
            {1e3, "|x| to 1000", upTo(1e3)},
            {1e5, "|x| to 10^5", upTo(1e5)},
            {1e7, "|x| to 10^7", upTo(1e7)}};
}
std::vector<ArgumentSweep> arcs() {
    return {{1e-3, "|x| from 10^-6 to 10^-3", signedMagnitudes(1e-6, 1e-3)},
            {.5, "|x| to 0.5", upTo(.5)},
            {.9, "|x| from 0.5 to 0.9", {.5, .9, false, true}},
            {1, "|x| from 0.9 to 1", {.9, 1, false, true}}};
}
std::vector<ArgumentSweep> exponents(double most) {
    return {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}, {most, "|x| to its limit", upTo(most)}};
}
std::vector<ArgumentSweep> upToTen() {
    return {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}};
}
std::vector<ArgumentSweep> positives() {
    return {{2, "x from 0.5 to 2", between(.5, 2)},
            {1e6, "x from 10^-6 to 10^6", magnitudes(1e-6, 1e6)},
            {1e30, "x from 10^-30 to 10^30", magnitudes(1e-30, 1e30)}};
}
std::vector<ArgumentSweep> pairs() {
    return {{2, "0.5 to 2", {.5, 2, false, true}, {.5, 2, false, true}},
            {1e6, "10^-6 to 10^6", signedMagnitudes(1e-6, 1e6), signedMagnitudes(1e-6, 1e6)}};
}
std::vector<ArgumentSweep> vectors() {
    return {{1, "to 1", upTo(1)}, {1e15, "from 10^-15 to 10^15", signedMagnitudes(1e-15, 1e15)}};
}
std::vector<ArgumentSweep> vectorPairs() {
    return {{1, "to 1", upTo(1), upTo(1)}};
}
std::vector<ArgumentSweep> plainSweeps() {
    return {{100, "|x| to 100", upTo(100)}, {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}};
}

long double exactLength(const A& x) {
    return std::hypot(std::hypot(x[0], x[1]), x[2]);
}

template <long double (*f)(long double)>
void of(const A& x, V& y) {
    y[0] = f(x[0]);
}
template <long double (*f)(long double, long double)>
void ofTwo(const A& x, V& y) {
    y[0] = f(x[0], x[4]);
}

}  // namespace

long double unitInLastPlace(long double value) {
    constexpr int kLowestExponent = -126;  // of normal floats
    if (value == 0) return 0x1p-149L;
    return std::ldexp(1.0L, std::max(std::ilogb(value), kLowestExponent) - 23);
}

std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index) {
    std::array<float, 8> arguments{};
    for (std::uint32_t slot = 0; slot < 8; ++slot) {
        const double u = index == 0 ? 0 : index == 1 ? 1 : uniform(index, slot);
        arguments[slot] = within(slot < 4 ? sweep.a : sweep.b, u);
    }
    return arguments;
}

std::span<const BuiltinFunction> builtinFunctions() {
    constexpr long double kDegree = std::numbers::pi_v<long double> / 180;
    static const std::vector<BuiltinFunction> table{
        {"sin", "trigonometric", "sin(a.x)", kOpen, of<sinl>, nullptr, angles()},
        {"cos", "trigonometric", "cos(a.x)", kOpen, of<cosl>, nullptr, angles()},
        {"tan", "trigonometric", "tan(a.x)", kOpen, of<tanl>, nullptr, angles()},

        {"asin", "inverse-trigonometric", "asin(a.x)", kOpen, of<asinl>, nullptr, arcs()},
        {"acos", "inverse-trigonometric", "acos(a.x)", kOpen, of<acosl>, nullptr, arcs()},
        {"atan",
         "inverse-trigonometric",
         "atan(a.x)",
         kOpen,
         of<atanl>,
         nullptr,
         {{1, "|x| to 1", upTo(1)},
          {10, "|x| from 1 to 10", {1, 10, false, true}},
          {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}}},
        {"atan(y, x)",
         "inverse-trigonometric",
         "atan(a.x, b.x)",
         kOpen,
         ofTwo<atan2l>,
         nullptr,
         {{1, "both to 1", upTo(1), upTo(1)},
          {1e3, "both from 10^-3 to 10^3", signedMagnitudes(1e-3, 1e3), signedMagnitudes(1e-3, 1e3)}}},

        {"exp", "exponential", "exp(a.x)", "(3 + 2|x|) ULP", of<expl>, bounds::exponential, exponents(80)},
        {"exp2", "exponential", "exp2(a.x)", "(3 + 2|x|) ULP", of<exp2l>, bounds::exponential,
         exponents(120)},
        {"log", "exponential", "log(a.x)", "3 ULP, 2^-21 from 0.5 to 2", of<logl>, bounds::logarithm,
         positives()},
        {"log2", "exponential", "log2(a.x)", "3 ULP, 2^-21 from 0.5 to 2", of<log2l>, bounds::logarithm,
         positives()},
        {"pow",
         "exponential",
         "pow(a.x, b.x)",
         "as exp2(y log2(x))",
         ofTwo<powl>,
         bounds::power,
         {{1, "x from 0.5 to 2, |y| to 1", between(.5, 2), upTo(1)},
          {10, "x from 0.01 to 100, |y| to 10", magnitudes(.01, 100), upTo(10)},
          {128, "x from 0.6 to 1, y from 1 to 128", between(.6, 1), between(1, 128)}}},
        {"sinh", "exponential", "sinh(a.x)", "as (exp(x) - exp(-x)) / 2", of<sinhl>, bounds::hyperbolic,
         upToTen()},
        {"cosh", "exponential", "cosh(a.x)", "as (exp(x) + exp(-x)) / 2", of<coshl>, bounds::hyperbolic,
         upToTen()},
        {"tanh", "exponential", "tanh(a.x)", "as sinh(x) / cosh(x)", of<tanhl>, bounds::hyperbolicTangent,
         upToTen()},

        {"product", "arithmetic", "a.x * b.x", "0.5 ULP", [](const A& x, V& y) { y[0] = x[0] * x[4]; },
         bounds::ulps<1>, pairs()},
        {"division", "arithmetic", "a.x / b.x", "2.5 ULP", [](const A& x, V& y) { y[0] = x[0] / x[4]; },
         bounds::ulps<5>, pairs()},
        {"1 / x", "arithmetic", "1. / a.x", "2.5 ULP", [](const A& x, V& y) { y[0] = 1 / x[0]; },
         bounds::ulps<5>, positives()},
        {"sqrt", "arithmetic", "sqrt(a.x)", "as 1 / inversesqrt(x)", of<sqrtl>, bounds::root, positives()},
        {"inversesqrt", "arithmetic", "inversesqrt(a.x)", "2 ULP",
         [](const A& x, V& y) { y[0] = 1 / std::sqrt(x[0]); }, bounds::ulps<4>, positives()},
        {"radians",
         "arithmetic",
         "radians(a.x)",
         "as pi / 180 x",
         [](const A& x, V& y) { y[0] = x[0] * kDegree; },
         bounds::angle,
         {{360, "|x| to 360", upTo(360)}}},

        {"floor", "common", "floor(a.x)", "exact", of<floorl>, bounds::none, plainSweeps()},
        {"roundEven", "common", "roundEven(a.x)", "exact", of<nearbyintl>, bounds::none, plainSweeps()},
        {"fract", "common", "fract(a.x)", "as x - floor(x)",
         [](const A& x, V& y) { y[0] = x[0] - std::floor(x[0]); }, bounds::ulps<1>, plainSweeps()},
        {"mod",
         "common",
         "mod(a.x, b.x)",
         "as x - y floor(x / y)",
         [](const A& x, V& y) { y[0] = x[0] - x[4] * std::floor(x[0] / x[4]); },
         bounds::modulus,
         {{100, "|x| to 100, y from 0.5 to 10", upTo(100), between(.5, 10)},
          {1e6, "|x| to 10^6, y from 0.5 to 10", upTo(1e6), between(.5, 10)}},
         1,
         [](const A& x) { return x[4]; }},
        {"mix",
         "common",
         "mix(a.x, a.y, b.x)",
         "as x (1 - t) + y t",
         [](const A& x, V& y) { y[0] = x[0] * (1 - x[4]) + x[1] * x[4]; },
         bounds::mixture,
         {{1, "x and y from 0 to 1", between(0, 1), between(0, 1)},
          {100, "|x| and |y| to 100", upTo(100), between(0, 1)}}},
        {"smoothstep",
         "common",
         "smoothstep(-a.x, a.y, b.x)",
         "as its polynomial",
         [](const A& x, V& y) {
             const long double t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.0L, 1.0L);
             y[0] = t * t * (3 - 2 * t);
         },
         bounds::smoothStep,
         {{1, "edges in 0.1 to 1, |x| to 1", between(.1, 1), upTo(1)}}},

        {"dot",
         "geometric",
         "dot(a, b)",
         "as products and sums",
         [](const A& x, V& y) {
             y[0] = 0;
             for (std::size_t i = 0; i < 4; ++i) y[0] += x[i] * x[i + 4];
         },
         bounds::dot,
         {{1, "positive", between(.1, 1), between(.1, 1)}, {2, "both signs", upTo(1), upTo(1)}}},
        {"length", "geometric", "length(a.xyz)", "as sqrt(dot(v, v))",
         [](const A& x, V& y) { y[0] = exactLength(x); }, bounds::length, vectors()},
        {"distance", "geometric", "distance(a.xyz, b.xyz)", "as length(a - b)",
         [](const A& x, V& y) { y[0] = std::hypot(std::hypot(x[0] - x[4], x[1] - x[5]), x[2] - x[6]); },
         bounds::distance, vectorPairs()},
        {"normalize", "geometric", "normalize(a.xyz)", "as v / length(v)",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] / exactLength(x);
         },
         bounds::normalized, vectors(), 3},
        {"cross", "geometric", "cross(a.xyz, b.xyz)", "as products and differences",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 3; ++i) {
                 const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                 y[i] = x[j] * x[k + 4] - x[k] * x[j + 4];
             }
         },
         bounds::cross, vectorPairs(), 3},
        {"reflect", "geometric", "reflect(a.xyz, b.xyz)", "as I - 2 dot(N, I) N",
         [](const A& x, V& y) {
             const long double dot = x[0] * x[4] + x[1] * x[5] + x[2] * x[6];
             for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] - 2 * dot * x[i + 4];
         },
         bounds::reflected, vectorPairs(), 3},
        {"mat2 * vec2", "geometric", "mat2(a) * b.xy", "as products and sums",
         [](const A& x, V& y) {
             for (std::size_t i = 0; i < 2; ++i) y[i] = x[i] * x[4] + x[i + 2] * x[5];
         },
         bounds::product, vectorPairs(), 2},
    };
    return table;
}

}  // namespace glibra::bench
