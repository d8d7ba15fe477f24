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
std::vector<ArgumentSweep> positives() {
    return {{2, "x from 0.5 to 2", between(.5, 2)},
            {1e6, "x from 10^-6 to 10^6", magnitudes(1e-6, 1e6)},
            {1e30, "x from 10^-30 to 10^30", magnitudes(1e-30, 1e30)}};
}
std::vector<ArgumentSweep> pairs() {
    return {{2, "0.5 to 2", {.5, 2, false, true}, {.5, 2, false, true}},
            {1e6, "10^-6 to 10^6", signedMagnitudes(1e-6, 1e6), signedMagnitudes(1e-6, 1e6)}};
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
        {.name = "sin",
         .group = "trigonometric",
         .expression = "sin(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::sin(x[0]); },
         .sweeps = angles()},
        {.name = "cos",
         .group = "trigonometric",
         .expression = "cos(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::cos(x[0]); },
         .sweeps = angles()},
        {.name = "tan",
         .group = "trigonometric",
         .expression = "tan(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::tan(x[0]); },
         .sweeps = angles()},

        {.name = "asin",
         .group = "inverse-trigonometric",
         .expression = "asin(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::asin(x[0]); },
         .sweeps = arcs()},
        {.name = "acos",
         .group = "inverse-trigonometric",
         .expression = "acos(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::acos(x[0]); },
         .sweeps = arcs()},
        {.name = "atan",
         .group = "inverse-trigonometric",
         .expression = "atan(a.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::atan(x[0]); },
         .sweeps = {{1, "|x| to 1", upTo(1)},
                    {10, "|x| from 1 to 10", {1, 10, false, true}},
                    {1e6, "|x| from 10^-6 to 10^6", signedMagnitudes(1e-6, 1e6)}}},
        {.name = "atan(y, x)",
         .group = "inverse-trigonometric",
         .expression = "atan(a.x, b.x)",
         .bound = kOpen,
         .exact = [](const A& x, V& y) { y[0] = std::atan2(x[0], x[4]); },
         .sweeps = {{1, "both to 1", upTo(1), upTo(1)},
                    {1e3, "both from 10^-3 to 10^3", signedMagnitudes(1e-3, 1e3),
                     signedMagnitudes(1e-3, 1e3)}}},

        {.name = "exp",
         .group = "exponential",
         .expression = "exp(a.x)",
         .bound = "(3 + 2|x|) ULP",
         .exact = [](const A& x, V& y) { y[0] = std::exp(x[0]); },
         .allowed = bounds::exponential,
         .sweeps = exponents(80)},
        {.name = "exp2",
         .group = "exponential",
         .expression = "exp2(a.x)",
         .bound = "(3 + 2|x|) ULP",
         .exact = [](const A& x, V& y) { y[0] = std::exp2(x[0]); },
         .allowed = bounds::exponential,
         .sweeps = exponents(120)},
        {.name = "log",
         .group = "exponential",
         .expression = "log(a.x)",
         .bound = "3 ULP, 2^-21 from 0.5 to 2",
         .exact = [](const A& x, V& y) { y[0] = std::log(x[0]); },
         .allowed = bounds::logarithm,
         .sweeps = positives()},
        {.name = "log2",
         .group = "exponential",
         .expression = "log2(a.x)",
         .bound = "3 ULP, 2^-21 from 0.5 to 2",
         .exact = [](const A& x, V& y) { y[0] = std::log2(x[0]); },
         .allowed = bounds::logarithm,
         .sweeps = positives()},
        {.name = "pow",
         .group = "exponential",
         .expression = "pow(a.x, b.x)",
         .bound = "as exp2(y log2(x))",
         .exact = [](const A& x, V& y) { y[0] = std::pow(x[0], x[4]); },
         .allowed = bounds::power,
         .sweeps = {{1, "x from 0.5 to 2, |y| to 1", between(.5, 2), upTo(1)},
                    {10, "x from 0.01 to 100, |y| to 10", magnitudes(.01, 100), upTo(10)},
                    {128, "x from 0.6 to 1, y from 1 to 128", between(.6, 1), between(1, 128)}}},
        {.name = "sinh",
         .group = "exponential",
         .expression = "sinh(a.x)",
         .bound = "as (exp(x) - exp(-x)) / 2",
         .exact = [](const A& x, V& y) { y[0] = std::sinh(x[0]); },
         .allowed = bounds::hyperbolic,
         .sweeps = {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}}},
        {.name = "cosh",
         .group = "exponential",
         .expression = "cosh(a.x)",
         .bound = "as (exp(x) + exp(-x)) / 2",
         .exact = [](const A& x, V& y) { y[0] = std::cosh(x[0]); },
         .allowed = bounds::hyperbolic,
         .sweeps = {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}}},
        {.name = "tanh",
         .group = "exponential",
         .expression = "tanh(a.x)",
         .bound = "as sinh(x) / cosh(x)",
         .exact = [](const A& x, V& y) { y[0] = std::tanh(x[0]); },
         .allowed = bounds::hyperbolicTangent,
         .sweeps = {{1, "|x| to 1", upTo(1)}, {10, "|x| to 10", upTo(10)}}},

        {.name = "product",
         .group = "arithmetic",
         .expression = "a.x * b.x",
         .bound = "0.5 ULP",
         .exact = [](const A& x, V& y) { y[0] = x[0] * x[4]; },
         .allowed = bounds::ulps<1>,
         .sweeps = pairs()},
        {.name = "division",
         .group = "arithmetic",
         .expression = "a.x / b.x",
         .bound = "2.5 ULP",
         .exact = [](const A& x, V& y) { y[0] = x[0] / x[4]; },
         .allowed = bounds::ulps<5>,
         .sweeps = pairs()},
        {.name = "1 / x",
         .group = "arithmetic",
         .expression = "1. / a.x",
         .bound = "2.5 ULP",
         .exact = [](const A& x, V& y) { y[0] = 1 / x[0]; },
         .allowed = bounds::ulps<5>,
         .sweeps = positives()},
        {.name = "sqrt",
         .group = "arithmetic",
         .expression = "sqrt(a.x)",
         .bound = "as 1 / inversesqrt(x)",
         .exact = [](const A& x, V& y) { y[0] = std::sqrt(x[0]); },
         .allowed = bounds::root,
         .sweeps = positives()},
        {.name = "inversesqrt",
         .group = "arithmetic",
         .expression = "inversesqrt(a.x)",
         .bound = "2 ULP",
         .exact = [](const A& x, V& y) { y[0] = 1 / std::sqrt(x[0]); },
         .allowed = bounds::ulps<4>,
         .sweeps = positives()},
        {.name = "radians",
         .group = "arithmetic",
         .expression = "radians(a.x)",
         .bound = "as pi / 180 x",
         .exact = [](const A& x, V& y) { y[0] = x[0] * kDegree; },
         .allowed = bounds::angle,
         .sweeps = {{360, "|x| to 360", upTo(360)}}},

        {.name = "floor",
         .group = "common",
         .expression = "floor(a.x)",
         .bound = "exact",
         .exact = [](const A& x, V& y) { y[0] = std::floor(x[0]); },
         .allowed = bounds::none,
         .sweeps = plainSweeps()},
        {.name = "roundEven",
         .group = "common",
         .expression = "roundEven(a.x)",
         .bound = "exact",
         .exact = [](const A& x, V& y) { y[0] = std::nearbyint(x[0]); },
         .allowed = bounds::none,
         .sweeps = plainSweeps()},
        {.name = "fract",
         .group = "common",
         .expression = "fract(a.x)",
         .bound = "as x - floor(x)",
         .exact = [](const A& x, V& y) { y[0] = x[0] - std::floor(x[0]); },
         .allowed = bounds::ulps<1>,
         .sweeps = plainSweeps()},
        {.name = "mod",
         .group = "common",
         .expression = "mod(a.x, b.x)",
         .bound = "as x - y floor(x / y)",
         .exact = [](const A& x, V& y) { y[0] = x[0] - x[4] * std::floor(x[0] / x[4]); },
         .allowed = bounds::modulus,
         .period = [](const A& x) { return x[4]; },
         .sweeps = {{100, "|x| to 100, y from 0.5 to 10", upTo(100), between(.5, 10)},
                    {1e6, "|x| to 10^6, y from 0.5 to 10", upTo(1e6), between(.5, 10)}}},
        {.name = "mix",
         .group = "common",
         .expression = "mix(a.x, a.y, b.x)",
         .bound = "as x (1 - t) + y t",
         .exact = [](const A& x, V& y) { y[0] = x[0] * (1 - x[4]) + x[1] * x[4]; },
         .allowed = bounds::mixture,
         .sweeps = {{1, "x and y from 0 to 1", between(0, 1), between(0, 1)},
                    {100, "|x| and |y| to 100", upTo(100), between(0, 1)}}},
        {.name = "smoothstep",
         .group = "common",
         .expression = "smoothstep(-a.x, a.y, b.x)",
         .bound = "as its polynomial",
         .exact =
             [](const A& x, V& y) {
                 const long double t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.0L, 1.0L);
                 y[0] = t * t * (3 - 2 * t);
             },
         .allowed = bounds::smoothStep,
         .sweeps = {{1, "edges in 0.1 to 1, |x| to 1", between(.1, 1), upTo(1)}}},

        {.name = "dot",
         .group = "geometric",
         .expression = "dot(a, b)",
         .bound = "as products and sums",
         .exact =
             [](const A& x, V& y) {
                 y[0] = 0;
                 for (std::size_t i = 0; i < 4; ++i) y[0] += x[i] * x[i + 4];
             },
         .allowed = bounds::dot,
         .sweeps = {{1, "positive", between(.1, 1), between(.1, 1)}, {2, "both signs", upTo(1), upTo(1)}}},
        {.name = "length",
         .group = "geometric",
         .expression = "length(a.xyz)",
         .bound = "as sqrt(dot(v, v))",
         .exact = [](const A& x, V& y) { y[0] = exactLength(x); },
         .allowed = bounds::length,
         .sweeps = {{1, "to 1", upTo(1)}, {1e15, "from 10^-15 to 10^15", signedMagnitudes(1e-15, 1e15)}}},
        {.name = "distance",
         .group = "geometric",
         .expression = "distance(a.xyz, b.xyz)",
         .bound = "as length(a - b)",
         .exact = [](const A& x,
                     V& y) { y[0] = std::hypot(std::hypot(x[0] - x[4], x[1] - x[5]), x[2] - x[6]); },
         .allowed = bounds::distance,
         .sweeps = {{1, "to 1", upTo(1), upTo(1)}}},
        {.name = "normalize",
         .group = "geometric",
         .expression = "normalize(a.xyz)",
         .components = 3,
         .bound = "as v / length(v)",
         .exact =
             [](const A& x, V& y) {
                 for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] / exactLength(x);
             },
         .allowed = bounds::normalized,
         .sweeps = {{1, "to 1", upTo(1)}, {1e15, "from 10^-15 to 10^15", signedMagnitudes(1e-15, 1e15)}}},
        {.name = "cross",
         .group = "geometric",
         .expression = "cross(a.xyz, b.xyz)",
         .components = 3,
         .bound = "as products and differences",
         .exact =
             [](const A& x, V& y) {
                 for (std::size_t i = 0; i < 3; ++i) {
                     const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                     y[i] = x[j] * x[k + 4] - x[k] * x[j + 4];
                 }
             },
         .allowed = bounds::cross,
         .sweeps = {{1, "to 1", upTo(1), upTo(1)}}},
        {.name = "reflect",
         .group = "geometric",
         .expression = "reflect(a.xyz, b.xyz)",
         .components = 3,
         .bound = "as I - 2 dot(N, I) N",
         .exact =
             [](const A& x, V& y) {
                 const long double dot = x[0] * x[4] + x[1] * x[5] + x[2] * x[6];
                 for (std::size_t i = 0; i < 3; ++i) y[i] = x[i] - 2 * dot * x[i + 4];
             },
         .allowed = bounds::reflected,
         .sweeps = {{1, "to 1", upTo(1), upTo(1)}}},
        {.name = "mat2 * vec2",
         .group = "geometric",
         .expression = "mat2(a) * b.xy",
         .components = 2,
         .bound = "as products and sums",
         .exact =
             [](const A& x, V& y) {
                 for (std::size_t i = 0; i < 2; ++i) y[i] = x[i] * x[4] + x[i + 2] * x[5];
             },
         .allowed = bounds::product,
         .sweeps = {{1, "to 1", upTo(1), upTo(1)}}},
    };
    return table;
}

}  // namespace glibra::bench
