// Time, noise and built-in functions at the ends of their ranges (exercises' accuracy table 34, 49, 56; NM06,
// NM07, NM18, NM38), and denormal numbers.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "support.h"

namespace glibra::stress {
namespace {

/// The value of an expression in a fragment stage.
std::array<float, 3> valueOf(const std::string& rgb, const std::string& uniforms = "",
                             const std::string& tags = "", double time = 0, const std::string& scene = "") {
    RenderOptions options;
    options.time = time;
    const FloatPicture picture =
        draw("WindowSize 1 1\nLookAt 0 0 5 0 0 0 0 1 0\n" + scene +
                 "Vertex v.vert\nFragment f.frag\nProgram P " + tags + "\nQuadXY 0 10\n",
             shaded(rgb, uniforms), options);
    return picture.width == 1 ? picture.at(0, 0) : std::array<float, 3>{};
}

TEST(Timer, IsTheFractionAfterAMillionSeconds) {
    for (const double period : {10., 7., .001, 1e6, 3.3})
        for (const double time : {1e6, 1e6 + 1 / 60., 1e6 + 12345.678, 86'400. * 365, 1e9 - .25}) {
            const long double turns = static_cast<long double>(time) / static_cast<long double>(period);
            const double expected = static_cast<double>(turns - std::floor(turns));
            const double seen = static_cast<double>(valueOf("vec3(Timer)", "uniform float Timer;\n", "", time,
                                                            fmt::format("Timer {}\n", period))[0]);
            // The rounding error of the expected value after this many turns, and that of the float result.
            const double bound = 1.1e-19 * static_cast<double>(turns) + 6e-8;
            const double difference = std::abs(seen - expected);
            EXPECT_LE(std::min(difference, 1 - difference), bound) << period << " " << time;
        }
}

TEST(Timer, NeverReachesOne) {
    // fract() is always below 1, even where float or double would round up.
    for (const double time : {10 - 1e-9, 1e6 + 10 - 1e-8, 10 * (1 - 1e-16), -1e-20, -1e-12, 1e9 - 1e-7})
        for (const double period : {10., 1.}) {
            const float seen = valueOf("vec3(Timer)", "uniform float Timer;\n", "", time,
                                       fmt::format("Timer {}\n", period))[0];
            EXPECT_LT(seen, 1.F) << time << " " << period;
            EXPECT_GE(seen, 0.F) << time << " " << period;
        }
}

TEST(Timer, PicturesASecondApartAreEqualAfterAMillionSeconds) {
    const float early = valueOf("vec3(Timer)", "uniform float Timer;\n", "", 3.25, "Timer 10\n")[0];
    const float late = valueOf("vec3(Timer)", "uniform float Timer;\n", "", 1e6 + 3.25, "Timer 10\n")[0];
    EXPECT_EQ(early, late);
}

// noise1 to noise4 of the language, implemented a second time from their definition, in double.

std::uint32_t mixed(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    return x ^ (x >> 16U);
}

double noise(const std::array<double, 4>& p, int dimension, std::uint32_t component) {
    constexpr std::array<std::uint32_t, 4> kFactors{0x8da6b343U, 0xd8163841U, 0xcb1ab31fU, 0x165667b1U};
    double sum = 0;
    for (unsigned corner = 0; corner < 1U << static_cast<unsigned>(dimension); ++corner) {
        std::uint32_t h = component * 0x85ebca6bU;
        double weight = 1;
        std::array<double, 4> offset{};
        for (unsigned k = 0; k < static_cast<unsigned>(dimension); ++k) {
            const double cell = std::floor(p[k]);
            const unsigned bit = corner >> k & 1U;
            h ^= static_cast<std::uint32_t>(static_cast<std::int64_t>(cell) + bit) * kFactors[k];
            const double t = p[k] - cell;
            const double w = t * t * t * (10 - 15 * t + 6 * t * t);
            weight *= bit != 0 ? w : 1 - w;
            offset[k] = t - bit;
        }
        h = mixed(h);
        std::array<double, 4> g{};
        double square = 0;
        for (unsigned k = 0; k < static_cast<unsigned>(dimension); ++k) {
            g[k] = (mixed(h + 0x9e3779b9U * k) >> 8U) / 8388608. - 1;
            square += g[k] * g[k];
        }
        const double length = std::sqrt(square);
        double dot = 0;
        for (unsigned k = 0; k < static_cast<unsigned>(dimension); ++k)
            dot += (length < .001 ? (k == 0 ? 1. : 0.) : g[k] / length) * offset[k];
        sum += weight * dot;
    }
    return 2 / std::sqrt(dimension) * sum;
}

TEST(NoiseFunctions, AreRightAtCoordinatesToTenMillion) {
    for (const double base : {0., -3., 1000., -1000., 65'536., 1e6, -1e6, 4e6, 1e7, -1e7, 1e9, 2e9}) {
        // Columns step by 1/8 along x, rows along y. Test and shader round coordinates to float in the same
        // way.
        const FloatPicture picture = draw(
            "WindowSize 32 32\nLookAt 0 0 5 0 0 0 0 1 0\nVertex v.vert\nFragment f.frag\nProgram P uBase " +
                number(base) + "\nQuadXY 0 10\n",
            shaded("vec3(noise1(uBase + q.x), noise1(vec3(uBase) + q), noise2(vec4(uBase, -uBase, uBase, "
                   "uBase) + q.xyzx).y)",
                   "uniform float uBase;\n#define q (.125 * vec3(floor(gl_FragCoord.xy), 3.))\n"));
        ASSERT_EQ(picture.width, 32);
        const auto at = [&](double offset, double sign = 1) {
            return static_cast<double>(static_cast<float>(sign * base) + static_cast<float>(offset));
        };
        double worst = 0;
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                const double qx = .125 * x;
                const double qy = .125 * (31 - y);
                const auto seen = picture.at(x, y);
                const std::array<double, 3> expected{noise({at(qx)}, 1, 0),
                                                     noise({at(qx), at(qy), at(.375)}, 3, 0),
                                                     noise({at(qx), at(qy, -1), at(.375), at(qx)}, 4, 1)};
                for (std::size_t i = 0; i < 3; ++i) {
                    worst = std::max(worst, std::abs(static_cast<double>(seen[i]) - expected[i]));
                    EXPECT_LE(std::abs(seen[i]), 1.F);
                }
            }
        EXPECT_LT(worst, 2e-6) << base;
    }
}

TEST(NoiseFunctions, AreFiniteAtAnyCoordinate) {
    for (const char* base : {"1e10", "-1e10", "1e20", "3e38", "-3e38", "1e-38", "1e-44"}) {
        const auto seen = valueOf("vec3(noise1(uBase), noise1(vec3(uBase)), noise3(vec4(uBase)).z)",
                                  "uniform float uBase;\n", std::string("uBase ") + base);
        for (const float each : seen) EXPECT_LE(std::abs(each), 1.F) << base;  // false for NaN
    }
}

/// |texture(p + far) - texture(p)| at points p that are 1/8 texel off the texel centres.
FloatPicture noiseShiftedBy(const std::string& far, const std::string& sampled) {
    return draw(
        "WindowSize 16 16\nLookAt 0 0 5 0 0 0 0 1 0\nVertex v.vert\nFragment f.frag\nProgram P uFar " + far +
            "\nQuadXY 0 10\n",
        shaded("abs(at(q + uFar) - at(q))",
               "uniform float uFar;\n#define q ((3. * vec3(floor(gl_FragCoord.xy), 7.) + .625) / 64.)\n"
               "vec3 at(vec3 p) { return " +
                   sampled + ".rgb; }\n"));
}

TEST(NoiseTextures, RepeatExactlyAtWholeCoordinates) {
    // A period has 64 texels, and p is a multiple of 1/8 texel. Coordinates up to 2^15 periods are exact in a
    // float, and so is the value.
    for (const char* sampled : {"texture(Noise3, p)", "texture(Noise2, p.xy)"})
        for (const char* far : {"1", "-1", "1000", "-4096", "30000"}) {
            const FloatPicture picture = noiseShiftedBy(far, sampled);
            EXPECT_EQ(picture.count([](const auto& rgb) { return rgb != std::array<float, 3>{}; }), 0U)
                << sampled << " " << far;
        }
}

TEST(NoiseTextures, StayInRangeFarBeyondTheirPrecision) {
    // A driver may multiply by the size before it takes the fraction. The value then comes from a nearby
    // texel.
    for (const char* sampled : {"texture(Noise3, p)", "texture(Noise2, p.xy)"})
        for (const char* far : {"1e5", "1e6", "1e7", "-1e7", "1e9", "1e30"}) {
            const FloatPicture picture = noiseShiftedBy(far, sampled);
            EXPECT_EQ(picture.nonFinite(), 0U) << sampled << " " << far;
            EXPECT_EQ(
                picture.count([](const auto& rgb) { return rgb[0] > .4F || rgb[1] > .25F || rgb[2] > .13F; }),
                0U)
                << sampled << " " << far;
        }
}

TEST(BuiltInFunctions, AreDefinedAtTheBordersOfTheirDomains) {
    struct Row {
        const char* expression;
        double value, tolerance;
    };
    constexpr double kPi = std::numbers::pi;
    // uOne is 1 and uZero is 0, but only at run time, so that compilers cannot evaluate the expressions.
    for (const Row& row : {Row{"acos(uOne)", 0, 5e-4},
                           Row{"acos(-uOne)", kPi, 5e-4},
                           Row{"asin(uOne)", kPi / 2, 5e-4},
                           Row{"asin(-uOne)", -kPi / 2, 5e-4},
                           Row{"acos(uZero)", kPi / 2, 5e-4},
                           Row{"acos(uOne - 6e-8)", 3.4e-4, 5e-4},
                           Row{"sqrt(uZero)", 0, 0},
                           Row{"sqrt(-uZero)", 0, 0},
                           Row{"pow(uZero, 2.)", 0, 0},
                           Row{"pow(uZero, .001)", 0, 0},
                           Row{"pow(uOne, 1e30)", 1, 0},
                           Row{"pow(2., uZero)", 1, 0},
                           Row{"pow(1e-30, uOne)", 1e-30, 1e-34},
                           Row{"pow(uOne * 1e30, 1.2)", 1e36, 1e31},
                           Row{"exp2(uOne * -149.)", 0, 2e-45},
                           Row{"exp(uOne * -200.)", 0, 0},
                           Row{"atan(uZero, uOne)", 0, 0},
                           Row{"atan(uZero, -uOne)", kPi, 1e-5},
                           Row{"atan(uOne, uZero)", kPi / 2, 1e-5},
                           Row{"atan(-uOne * 1e30, uZero)", -kPi / 2, 1e-5},
                           Row{"atan(uOne * 1e30, 1e-30)", kPi / 2, 1e-5},
                           Row{"atan(uOne * 1e-30, 1e30)", 0, 1e-5},
                           Row{"mod(uOne * 1e7, .75)", .25, 1},
                           Row{"fract(uOne * 1e7)", 0, 0},
                           Row{"fract(-uOne * 1e-9)", 1, 6e-8},
                           Row{"smoothstep(uZero, uOne, uZero)", 0, 0},
                           Row{"smoothstep(uZero, uOne, uOne)", 1, 0},
                           Row{"tanh(uOne * 100.)", 1, 1e-6},
                           Row{"tanh(uOne * -100.)", -1, 1e-6},
                           Row{"length(vec3(uOne * 1e15))", 1.7320508e15, 1e9},
                           Row{"log(uOne)", 0, 1e-6},
                           Row{"clamp(uOne * 1e38, 0., 1.)", 1, 0},
                           Row{"floor(uOne * -1e-20)", -1, 0}}) {
        const double seen =
            static_cast<double>(valueOf(std::string("vec3(") + row.expression + ")",
                                        "uniform float uOne;\nuniform float uZero;\n", "uOne 1 uZero 0")[0]);
        EXPECT_NEAR(seen, row.value, row.tolerance) << row.expression;
    }
}

TEST(BuiltInFunctions, SmoothstepWithEqualEdgesIsAStep) {
    // GLSL does not define this, but a slider at 0 leads to it. The result must be a sharp edge, without NaN
    // where x equals the edge.
    const std::string declarations = "uniform float uTol;\n";
    for (const char* tolerance : {"0", "1e-30", "1e-7"}) {
        const FloatPicture picture = draw(
            "WindowSize 64 1\nLookAt 0 0 5 0 0 0 0 1 0\nVertex v.vert\nFragment f.frag\nProgram P uTol " +
                std::string(tolerance) + "\nQuadXY 0 1000\n",
            shaded("vec3(smoothstep(.5 - uTol, .5 + uTol, floor(gl_FragCoord.x) / 32.), 0., 0.)",
                   declarations));
        ASSERT_EQ(picture.width, 64);
        EXPECT_EQ(picture.nonFinite(), 0U) << tolerance;
        for (int x = 0; x < 64; ++x) {
            const float seen = picture.at(x, 0)[0];
            if (x == 16)
                EXPECT_TRUE(seen >= 0 && seen <= 1) << tolerance;
            else
                EXPECT_EQ(seen, x < 16 ? 0.F : 1.F) << tolerance << " " << x;
        }
    }
}

TEST(DenormalNumbers, AreKeptOrZeroAndNeverBroken) {
    // A driver may flush them to zero. glibra's own arithmetic must not change them in any other way.
    for (const char* value : {"1e-39", "-1e-39", "1.4e-45", "1e-50", "-1e-300"}) {
        const double written = std::stod(std::string(value));
        const auto asFloat = static_cast<float>(written);
        const float seen = valueOf("vec3(uD)", "uniform float uD;\n", std::string("uD ") + value)[0];
        EXPECT_TRUE(seen == asFloat || seen == 0) << value << " " << seen;
    }
    const std::string view = "WindowSize 32 32\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 5 0 0 0 0 1 0\n";
    const Files files = shaded("vec3(1., vMC.xy)");
    const FloatPicture zero = draw(view + kProgram + "Triangles [0 0 0] [.7 0 0] [0 .7 0]\n", files);
    const FloatPicture tiny = draw(view + "Translate 1e-40 -1e-42 1e-45\n" + kProgram +
                                       "Triangles [1e-40 1e-45 -1e-44] [.7 -1e-40 1e-39] [-1e-41 .7 1e-44]\n",
                                   files);
    ASSERT_EQ(tiny.values.size(), zero.values.size());
    EXPECT_EQ(tiny.nonFinite(), 0U);
    for (std::size_t i = 0; i < zero.values.size(); ++i)
        EXPECT_NEAR(tiny.values[i], zero.values[i], 1e-6F) << i;
}

}  // namespace
}  // namespace glibra::stress
