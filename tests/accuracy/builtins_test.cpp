#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include "bench/subjects/builtins.h"
#include "gpu/context/context.h"

namespace glibra::bench {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_50;

const BuiltinFunction& functionOf(std::string_view name) {
    for (const BuiltinFunction& each : builtinFunctions())
        if (each.name == name) return each;
    throw std::runtime_error("no function " + std::string(name));
}

/// The results of a device that computes each result of a sweep by `answer`.
std::vector<Four> answers(const ArgumentSweep& sweep, std::uint32_t count,
                          const std::function<std::array<float, 3>(const std::array<float, 8>&)>& answer) {
    std::vector<Four> results;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::array<float, 3> values = answer(argumentsOf(sweep, i));
        results.emplace_back(values[0], values[1], values[2], 0);
    }
    return results;
}

TEST(UnitInLastPlace, IsTheDistanceToTheNextFloat) {
    for (const float value : {1.f, 1.5f, 3e38f, 1e-30f, 1.1754944e-38f, 1e-40f}) {
        const float next = std::nextafter(value, std::numeric_limits<float>::infinity());
        EXPECT_EQ(static_cast<double>(unitInLastPlace(value)),
                  static_cast<double>(next) - static_cast<double>(value))
            << value;
        EXPECT_EQ(unitInLastPlace(-value), unitInLastPlace(value));
    }
}

TEST(JudgedPrecision, OfRoundedResultsIsHalfAUnit) {
    const BuiltinFunction& function = functionOf("sqrt");
    const ArgumentSweep& sweep = function.sweeps.front();
    const Precision precision = judgePrecision(
        function, sweep, answers(sweep, 1000, [](const auto& x) {
            return std::array<float, 3>{static_cast<float>(std::sqrt(static_cast<double>(x[0]))), 0, 0};
        }));
    EXPECT_LE(precision.largest, .5);
    EXPECT_GT(precision.largest, .45);
    EXPECT_NEAR(precision.mean, .25, .03);
    EXPECT_EQ(precision.samples, 1000U);
    EXPECT_LT(precision.timesTheBound.value(), 1);
}

TEST(JudgedPrecision, CountsTheUnitsByWhichAResultIsWrong) {
    const BuiltinFunction& function = functionOf("division");
    const ArgumentSweep& sweep = function.sweeps.front();
    const auto off = [&](int units) {
        return judgePrecision(function, sweep, answers(sweep, 500, [&](const auto& x) {
                                  float value = x[0] / x[4];
                                  for (int i = 0; i < units; ++i) value = std::nextafter(value, 1e30f);
                                  return std::array<float, 3>{value, 0, 0};
                              }));
    };
    EXPECT_NEAR(off(4).largest, 4.25, .25);
    EXPECT_NEAR(off(4).mean, 4, .25);
    EXPECT_GT(off(4).timesTheBound.value(), 1);
    EXPECT_LT(off(2).timesTheBound.value(), 1.0001);
}

TEST(JudgedPrecision, ReportsNotANumberAndItsArguments) {
    const BuiltinFunction& function = functionOf("exp");
    const ArgumentSweep& sweep = function.sweeps.front();
    std::vector<Four> results =
        answers(sweep, 100, [](const auto& x) { return std::array<float, 3>{std::exp(x[0]), 0, 0}; });
    results[17].x = std::numeric_limits<float>::quiet_NaN();
    const Precision precision = judgePrecision(function, sweep, results);
    EXPECT_EQ(precision.notNumbers, 1U);
    EXPECT_TRUE(std::isinf(precision.largest));
    EXPECT_TRUE(std::isfinite(precision.mean));
    EXPECT_EQ(precision.worst, argumentsOf(sweep, 17));
}

TEST(JudgedPrecision, LetsAnArgumentAtABorderFallToEitherSide) {
    const BuiltinFunction& function = functionOf("mod");
    const ArgumentSweep border{10, "a border", {10, 10}, {2.5, 2.5}};
    const auto judged = [&](float got) { return judgePrecision(function, border, {Four(got)}); };
    EXPECT_EQ(judged(0).largest, 0);
    EXPECT_EQ(judged(2.5f).largest, 0);
    EXPECT_GT(judged(1.25f).largest, 1e6);
    EXPECT_GT(judgePrecision(function, {11, "no border", {11, 11}, {2.5, 2.5}}, {Four(3.5f)}).largest, 1e6);
}

TEST(BuiltinFunctions, EqualWiderArithmetic) {
    namespace mp = boost::multiprecision;
    const std::map<std::string, std::function<Wide(const std::array<Wide, 8>&)>> wide{
        {"sin", [](const auto& x) { return mp::sin(x[0]); }},
        {"cos", [](const auto& x) { return mp::cos(x[0]); }},
        {"tan", [](const auto& x) { return mp::tan(x[0]); }},
        {"asin", [](const auto& x) { return mp::asin(x[0]); }},
        {"acos", [](const auto& x) { return mp::acos(x[0]); }},
        {"atan", [](const auto& x) { return mp::atan(x[0]); }},
        {"atan(y, x)", [](const auto& x) { return mp::atan2(x[0], x[4]); }},
        {"exp", [](const auto& x) { return mp::exp(x[0]); }},
        {"exp2", [](const auto& x) { return mp::pow(Wide(2), x[0]); }},
        {"log", [](const auto& x) { return mp::log(x[0]); }},
        {"log2", [](const auto& x) { return Wide(mp::log(x[0]) / mp::log(Wide(2))); }},
        {"pow", [](const auto& x) { return mp::pow(x[0], x[4]); }},
        {"sinh", [](const auto& x) { return mp::sinh(x[0]); }},
        {"tanh", [](const auto& x) { return mp::tanh(x[0]); }},
        {"inversesqrt", [](const auto& x) { return Wide(1 / mp::sqrt(x[0])); }},
        {"mod", [](const auto& x) { return Wide(x[0] - x[4] * mp::floor(x[0] / x[4])); }}};
    for (const auto& [name, evaluate] : wide) {
        const BuiltinFunction& function = functionOf(name);
        for (const ArgumentSweep& sweep : function.sweeps)
            for (std::uint32_t i = 0; i < 60; ++i) {
                const std::array<float, 8> given = argumentsOf(sweep, i);
                Arguments arguments{};
                std::array<Wide, 8> wideArguments;
                std::copy(given.begin(), given.end(), arguments.begin());
                std::copy(given.begin(), given.end(), wideArguments.begin());
                Values got{};
                function.exact(arguments, got);
                const auto wanted = evaluate(wideArguments).convert_to<long double>();
                // A thousandth of the smallest reported error.
                EXPECT_NEAR(static_cast<double>((got[0] - wanted) / unitInLastPlace(wanted)), 0, 1e-3)
                    << name << " at " << argumentsText(function, given);
            }
    }
}

TEST(BuiltinFunctions, BoundsHoldForTheEquationsInFloat) {
    const auto dot3 = [](const std::array<float, 8>& x, std::size_t a, std::size_t b) {
        return x[a] * x[b] + x[a + 1] * x[b + 1] + x[a + 2] * x[b + 2];
    };
    using Floats = std::array<float, 8>;
    using Three = std::array<float, 3>;
    const std::map<std::string, std::function<Three(const Floats&)>> inFloat{
        {"sqrt", [](const Floats& x) { return Three{1 / (1 / std::sqrt(x[0])), 0, 0}; }},
        {"radians", [](const Floats& x) { return Three{x[0] * .017453292f, 0, 0}; }},
        {"mix", [](const Floats& x) { return Three{x[0] * (1 - x[4]) + x[1] * x[4], 0, 0}; }},
        {"fract", [](const Floats& x) { return Three{x[0] - std::floor(x[0]), 0, 0}; }},
        {"mod", [](const Floats& x) { return Three{x[0] - x[4] * std::floor(x[0] / x[4]), 0, 0}; }},
        {"smoothstep",
         [](const Floats& x) {
             const float t = std::clamp((x[4] + x[0]) / (x[1] + x[0]), 0.f, 1.f);
             return Three{t * t * (3 - 2 * t), 0, 0};
         }},
        {"dot",
         [](const Floats& x) { return Three{x[0] * x[4] + x[1] * x[5] + x[2] * x[6] + x[3] * x[7], 0, 0}; }},
        {"length", [&](const Floats& x) { return Three{std::sqrt(dot3(x, 0, 0)), 0, 0}; }},
        {"normalize",
         [&](const Floats& x) {
             const float length = std::sqrt(dot3(x, 0, 0));
             return Three{x[0] / length, x[1] / length, x[2] / length};
         }},
        {"reflect",
         [&](const Floats& x) {
             const float twice = 2 * dot3(x, 0, 4);
             return Three{x[0] - twice * x[4], x[1] - twice * x[5], x[2] - twice * x[6]};
         }},
        {"cross",
         [](const Floats& x) {
             return Three{x[1] * x[6] - x[2] * x[5], x[2] * x[4] - x[0] * x[6], x[0] * x[5] - x[1] * x[4]};
         }},
        {"mat2 * vec2",
         [](const Floats& x) { return Three{x[0] * x[4] + x[2] * x[5], x[1] * x[4] + x[3] * x[5], 0}; }}};
    for (const auto& [name, evaluate] : inFloat) {
        const BuiltinFunction& function = functionOf(name);
        for (const ArgumentSweep& sweep : function.sweeps) {
            const double timesTheBound =
                judgePrecision(function, sweep, answers(sweep, 20'000, evaluate)).timesTheBound.value();
            EXPECT_LE(timesTheBound, 1.0001) << name << " over " << sweep.words;
            EXPECT_GT(timesTheBound, .05) << "the bound says nothing: " << name << " over " << sweep.words;
        }
    }
}

TEST(BuiltinFunctions, PrintTheArgumentsTheyRead) {
    const std::array<float, 8> x{1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(argumentsText(functionOf("sin"), x), "1");
    EXPECT_EQ(argumentsText(functionOf("atan(y, x)"), x), "1, 5");
    EXPECT_EQ(argumentsText(functionOf("smoothstep"), x), "1, 2, 5");
    EXPECT_EQ(argumentsText(functionOf("normalize"), x), "1, 2, 3");
    EXPECT_EQ(argumentsText(functionOf("mat2 * vec2"), x), "1, 2, 3, 4, 5, 6");
}

TEST(PrecisionOfTheDriver, IsMeasuredOnTheIntendedArguments) {
    Bench bench({});
    const std::vector<PrecisionRow> rows = precisionTable(bench, 16);
    std::size_t sweeps = 0;
    for (const BuiltinFunction& function : builtinFunctions()) sweeps += function.sweeps.size();
    EXPECT_EQ(rows.size(), sweeps);
    for (const PrecisionRow& row : rows) {
        EXPECT_EQ(row.fragment.samples, 256U);
        // Exact operations, rounded: the result for another argument would differ by millions of units.
        const std::string_view name = row.function->name;
        const bool isRounded = name == "floor" || name == "product" || name == "roundEven";
        for (const Precision& each : {row.vertex, row.fragment}) {
            EXPECT_TRUE(!isRounded || each.largest <= .5) << name << " over " << row.sweep->words;
            EXPECT_TRUE(row.function->group != "exponential" || each.largest > 0)
                << name << " over " << row.sweep->words;
        }
    }
    EXPECT_NE(toText(rows).find("inversesqrt"), std::string::npos);
}

}  // namespace
}  // namespace glibra::bench
