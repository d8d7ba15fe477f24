#include "bench/reference/builtin_functions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/reference/builtin_bounds.h"

namespace glibra::bench {
namespace {

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

}  // namespace

std::span<const BuiltinFunction> builtinFunctions() {
    constexpr long double kDegree = std::numbers::pi_v<long double> / 180;
    static const std::vector<BuiltinFunction> table{
        {"sin", "trigonometric", "sin(a.x)", kOpen, [](const A& x, V& y) { y[0] = std::sin(x[0]); }, nullptr,
         angles()},
        {"cos", "trigonometric", "cos(a.x)", kOpen, [](const A& x, V& y) { y[0] = std::cos(x[0]); }, nullptr,
         angles()},
        {"tan", "trigonometric", "tan(a.x)", kOpen, [](const A& x, V& y) { y[0] = std::tan(x[0]); }, nullptr,
         angles()},

        {"asin", "inverse-trigonometric", "asin(a.x)", kOpen,
         [](const A& x, V& y) { y[0] = std::asin(x[0]); }, nullptr, arcs()},
        {"acos", "inverse-trigonometric", "acos(a.x)", kOpen,
         [](const A& x, V& y) { y[0] = std::acos(x[0]); }, nullptr, arcs()},
        {"atan",
         "inverse-trigonometric",
         "atan(a.x)",
         kOpen,
         [](const A& x, V& y) { y[0] = std::atan(x[0]); },
         nullptr,
         {{1, "|x| to 1", upTo(1)},
          {10, "|x| from 1 to 10", {1, 10, false, true}},
          {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}}},
        {"atan(y, x)",
         "inverse-trigonometric",
         "atan(a.x, b.x)",
         kOpen,
         [](const A& x, V& y) { y[0] = std::atan2(x[0], x[4]); },
         nullptr,
         {{1, "both to 1", upTo(1), upTo(1)},
          {1e3, "both from 10^-3 to 10^3", signedMagnitudes(1e-3, 1e3), signedMagnitudes(1e-3, 1e3)}}},

        {"exp", "exponential", "exp(a.x)", "(3 + 2|x|) ULP", [](const A& x, V& y) { y[0] = std::exp(x[0]); },
         bounds::exponential, exponents(80)},
        {"exp2", "exponential", "exp2(a.x)", "(3 + 2|x|) ULP",
         [](const A& x, V& y) { y[0] = std::exp2(x[0]); }, bounds::exponential, exponents(120)},
        {"log", "exponential", "log(a.x)", "3 ULP, 2^-21 from 0.5 to 2",
         [](const A& x, V& y) { y[0] = std::log(x[0]); }, bounds::logarithm, positives()},
        {"log2", "exponential", "log2(a.x)", "3 ULP, 2^-21 from 0.5 to 2",
         [](const A& x, V& y) { y[0] = std::log2(x[0]); }, bounds::logarithm, positives()},
        {"pow",
         "exponential",
         "pow(a.x, b.x)",
         "as exp2(y log2(x))",
         [](const A& x, V& y) { y[0] = std::pow(x[0], x[4]); },
         bounds::power,
         {{1, "x from 0.5 to 2, |y| to 1", between(.5, 2), upTo(1)},
          {10, "x from 0.01 to 100, |y| to 10", magnitudes(.01, 100), upTo(10)},
          {128, "x from 0.6 to 1, y from 1 to 128", between(.6, 1), between(1, 128)}}},
        {"sinh", "exponential", "sinh(a.x)", "as (exp(x) - exp(-x)) / 2",
         [](const A& x, V& y) { y[0] = std::sinh(x[0]); }, bounds::hyperbolic, upToTen()},
        {"cosh", "exponential", "cosh(a.x)", "as (exp(x) + exp(-x)) / 2",
         [](const A& x, V& y) { y[0] = std::cosh(x[0]); }, bounds::hyperbolic, upToTen()},
        {"tanh", "exponential", "tanh(a.x)", "as sinh(x) / cosh(x)",
         [](const A& x, V& y) { y[0] = std::tanh(x[0]); }, bounds::hyperbolicTangent, upToTen()},

        {"product", "arithmetic", "a.x * b.x", "0.5 ULP", [](const A& x, V& y) { y[0] = x[0] * x[4]; },
         bounds::ulps<1>, pairs()},
        {"division", "arithmetic", "a.x / b.x", "2.5 ULP", [](const A& x, V& y) { y[0] = x[0] / x[4]; },
         bounds::ulps<5>, pairs()},
        {"1 / x", "arithmetic", "1. / a.x", "2.5 ULP", [](const A& x, V& y) { y[0] = 1 / x[0]; },
         bounds::ulps<5>, positives()},
        {"sqrt", "arithmetic", "sqrt(a.x)", "as 1 / inversesqrt(x)",
         [](const A& x, V& y) { y[0] = std::sqrt(x[0]); }, bounds::root, positives()},
        {"inversesqrt", "arithmetic", "inversesqrt(a.x)", "2 ULP",
         [](const A& x, V& y) { y[0] = 1 / std::sqrt(x[0]); }, bounds::ulps<4>, positives()},
        {"radians",
         "arithmetic",
         "radians(a.x)",
         "as pi / 180 x",
         [](const A& x, V& y) { y[0] = x[0] * kDegree; },
         bounds::angle,
         {{360, "|x| to 360", upTo(360)}}},

        {"floor", "common", "floor(a.x)", "exact", [](const A& x, V& y) { y[0] = std::floor(x[0]); },
         bounds::none, plainSweeps()},
        {"roundEven", "common", "roundEven(a.x)", "exact",
         [](const A& x, V& y) { y[0] = std::nearbyint(x[0]); }, bounds::none, plainSweeps()},
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
