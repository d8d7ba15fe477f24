// Shading formulas compared with double precision: hue at the end of its circle (NM20), attenuation of light
// and the edge of a spot light (NM31), hyperbolic compression (NM36), weights of filters (NM37), and fog
// (exercises' accuracy table 52).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "support.h"

namespace glibra::stress {
namespace {

using Rgb = std::array<double, 3>;

/// Hue, saturation, value and back by the six sectors of the circle (Smith 1978).
Rgb turned(const Rgb& rgb, double degrees) {
    const double largest = std::max({rgb[0], rgb[1], rgb[2]});
    const double span = largest - std::min({rgb[0], rgb[1], rgb[2]});
    if (span == 0) return rgb;
    double hue = rgb[0] == largest   ? (rgb[1] - rgb[2]) / span
                 : rgb[1] == largest ? 2 + (rgb[2] - rgb[0]) / span
                                     : 4 + (rgb[0] - rgb[1]) / span;
    hue = std::fmod(hue + degrees / 60 + 12, 6);
    const int sector = std::min(5, static_cast<int>(hue));
    const double part = hue - sector;
    const double low = largest - span;
    const double falling = largest - span * part;
    const double rising = low + span * part;
    switch (sector) {
        case 0:
            return {largest, rising, low};
        case 1:
            return {falling, largest, low};
        case 2:
            return {low, largest, rising};
        case 3:
            return {low, falling, largest};
        case 4:
            return {rising, low, largest};
        default:
            return {largest, low, falling};
    }
}

TEST(HueShift, ComesBackAtTheFullCircleAndIsRightAtEverySector) {
    // Red, approached from below: the hue is a few millionths less than 360 degrees.
    const std::vector<Rgb> colors{{1, 0, 0},    {1, 1, 0},    {0, 1, 0},    {0, 1, 1},    {0, 0, 1},
                                  {1, 0, 1},    {0, 0, 0},    {1, 1, 1},    {.5, .5, .5}, {1, 0, 1e-7},
                                  {1, 1e-7, 0}, {.2, .7, .4}, {.3, .1, .9}, {1, .5, .25}, {1e-30, 0, 0}};
    std::string list;
    for (const Rgb& each : colors)
        list += fmt::format("{}vec3({}, {}, {})", list.empty() ? "" : ", ", each[0], each[1], each[2]);
    std::string fragment = replaced(shipped("image/hue_shift.frag"), "texture(uImageUnit, vST).rgb",
                                    "given[int(gl_FragCoord.x)]");
    fragment = replaced(fragment, "uniform sampler2D uImageUnit;",
                        fmt::format("const vec3 given[{}] = vec3[]({});", colors.size(), list));
    const Files files{{"v.vert", shipped("image/picture.vert")}, {"f.frag", fragment}};
    for (const double degrees : {0., 60., 119.99999, 120., 180., 240., 300., 359.99997, 360.}) {
        const FloatPicture picture = draw(fmt::format("WindowSize {} 1\n{}Program P uT {}\nQuadXY 0 999\n",
                                                      colors.size(), kFlatView, degrees),
                                          files);
        ASSERT_EQ(picture.width, static_cast<int>(colors.size()));
        EXPECT_EQ(picture.nonFinite(), 0U);
        for (int i = 0; i < picture.width; ++i) {
            const Rgb expected = turned(colors[static_cast<std::size_t>(i)], degrees);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(static_cast<double>(picture.at(i, 0)[k]), expected[k], 3e-6)
                    << "colour " << i << " turned by " << degrees;
        }
    }
}

TEST(LightAttenuation, IsTheQuotientOfItsPolynomial) {
    // One column per distance, from 1/100 to 1e6, compared with double precision on the CPU.
    constexpr int kColumns = 64;
    for (const auto& [a, b, c] : {std::array{1., 0., 0.}, std::array{1., .7, 1.8}, std::array{0., 0., 1.},
                                  std::array{0., 1e-3, 0.}, std::array{1., 1e-6, 1e-12}}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize {} 1\n{}Program P uA {} uB {} uC {}\nQuadXY 0 999\n", kColumns,
                             kFlatView, number(a), number(b), number(c)),
                 shaded("1. / (uA + uB * d + uC * d * d), d, 0.",
                        "uniform float uA, uB, uC;\n#define d exp2(floor(gl_FragCoord.x) * .4 - 6.)\n"));
        ASSERT_EQ(picture.width, kColumns);
        for (int x = 0; x < kColumns; ++x) {
            const auto d = static_cast<double>(picture.at(x, 0)[1]);
            EXPECT_NEAR(d, std::exp2(x * .4 - 6), 1e-5 * d);
            const double expected = 1 / (a + b * d + c * d * d);
            // The sum has three rounding errors and the quotient one, of half a unit each.
            EXPECT_NEAR(static_cast<double>(picture.at(x, 0)[0]), expected, 4 * 0x1p-23 * expected) << d;
        }
    }
}

TEST(LightAttenuation, DoesNotApplyToLightsThatScenesCannotDefine) {
    const FloatPicture picture = draw(
        "WindowSize 8 1\n" + kFlatView + "Program P\nQuadXY 0 999\n",
        {{"v.vert",
          "#version 120\nvarying float d;\nvoid main() { d = length(gl_Vertex.xyz); gl_Position = "
          "ftransform(); }\n"},
         {"f.frag",
          "#version 120\nvarying float d;\nvoid main() {\n"
          "  float f = 1. / (gl_LightSource[0].constantAttenuation + gl_LightSource[0].linearAttenuation * d "
          "+ gl_LightSource[0].quadraticAttenuation * d * d);\n"
          "  gl_FragColor = vec4(f, gl_LightSource[3].spotCosCutoff, gl_LightSource[7].spotExponent, 1.);\n"
          "}\n"}});
    EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] == 1 && rgb[1] == -1 && rgb[2] == 0; }), 8U);
}

TEST(SpotLight, FallsFromFullLightToNoneAcrossItsEdge) {
    constexpr int kSide = 48;
    const Files files{{"v.vert", shipped("shading/phong.vert")},
                      {"f.frag", shipped("shading/spot_light.frag")}};
    for (const auto& [angle, width] :
         {std::pair(25., 5.), std::pair(6., 1.), std::pair(1., .1), std::pair(2., 3.)}) {
        const FloatPicture picture = draw(
            fmt::format("WindowSize {0} {0}\nBackground 0\nOrtho -3 3 -3 3\nLookAt 0 0 5 0 0 0 0 1 0\nVertex "
                        "v.vert\nFragment f.frag\nProgram P uAngle {1} uWidth {2} uLeftRight .4 uColor {{1 1 "
                        "1}}\nQuadXY 0 3\n",
                        kSide, angle, width),
            files);
        ASSERT_EQ(picture.width, kSide);
        const glm::dvec3 light(0, 2, 2);
        const glm::dvec3 axis = glm::normalize(glm::dvec3(.4, 0, -4.4) - light);
        const double inner = std::cos(kDegree * std::max(angle - width, 0.));
        const double outer = std::cos(kDegree * (angle + width));
        std::array<int, 3> kinds{};
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const glm::dvec3 place(6 * (x + .5) / kSide - 3, 3 - 6 * (y + .5) / kSide, -5);
                const glm::dvec3 toFragment = glm::normalize(place - light);
                const double cosine = glm::dot(axis, toFragment);
                const double t = std::clamp((cosine - outer) / (inner - outer), 0., 1.);
                const double cone = t * t * (3 - 2 * t);
                ++kinds[t <= 0 ? 0 : t < 1 ? 1 : 2];
                const double expected = .12 + .88 * cone * std::abs(toFragment.z);
                // The rounding error of the cosines, relative to the width of the edge.
                const double bound = 1e-5 + 1.5 * .88 * 6 * 0x1p-24 / (inner - outer);
                EXPECT_NEAR(static_cast<double>(picture.at(x, y)[0]), expected, bound)
                    << angle << " " << width << " at " << x << ", " << y;
            }
        for (const int each : kinds)
            EXPECT_TRUE(angle < 20 || each > 50) << "dark, edge and light are all seen";
    }
}

TEST(HyperbolicZoom, CompressesEveryDistanceIntoOne) {
    constexpr int kColumns = 128;
    for (const double k : {1e-6, .01, .3, 1., 100.}) {
        const FloatPicture picture = draw(
            fmt::format("WindowSize {} 1\n{}Program P uK {}\nQuadXY 0 999\n", kColumns, kFlatView, number(k)),
            shaded("x / sqrt(x * x + uK * uK), r / (r + uK), 8. * r / (8. * r + uK) - r / (r + uK / 8.)",
                   "uniform float uK;\n#define x ((gl_FragCoord.x - 64.) * .25)\n#define r abs(x)\n"));
        ASSERT_EQ(picture.width, kColumns);
        EXPECT_EQ(picture.nonFinite(), 0U);
        for (int i = 0; i < kColumns; ++i) {
            const double x = (i + .5 - 64) * .25;
            const double r = std::abs(x);
            const auto seen = picture.at(i, 0);
            EXPECT_NEAR(static_cast<double>(seen[0]), x / std::hypot(x, k), 4e-7) << k << " " << x;
            EXPECT_NEAR(static_cast<double>(seen[1]), r / (r + k), 3e-7) << k << " " << x;
            EXPECT_NEAR(static_cast<double>(seen[2]), 0, 3e-7) << "r' of s and k is that of 1 and k / s";
            // GLSL allows 2.5 units in the last place for a division (4.60, 4.7.1), and 2 for a square root.
            constexpr float kRounding = 3e-7F;
            EXPECT_LE(std::abs(seen[0]), 1.F + kRounding);
            EXPECT_LE(seen[1], 1.F + kRounding);
            EXPECT_EQ(seen[0], -picture.at(kColumns - 1 - i, 0)[0]) << "odd";
            EXPECT_GE(seen[0], picture.at(std::max(0, i - 1), 0)[0] - kRounding) << "rising";
        }
        // For k towards 0 the result tends to the sign of x, not to x.
        if (k == 1e-6) {
            EXPECT_NEAR(picture.at(0, 0)[0], -1.F, 3e-7F);
            EXPECT_NEAR(picture.at(64, 0)[0], 1.F, 3e-7F);
            EXPECT_NEAR(static_cast<double>(picture.at(64, 0)[1]), 1, 1e-5);
        }
    }
}

TEST(HyperbolicZoom, HasNoValueAtTheCentreWithoutItsConstant) {
    const FloatPicture picture =
        draw("WindowSize 1 1\n" + kFlatView + "Program P uK 0 uX 0\nQuadXY 0 999\n",
             shaded("uX / sqrt(uX * uX + uK * uK), 0., 0.", "uniform float uK, uX;\n"));
    EXPECT_EQ(picture.nonFinite(), 1U);
}

TEST(Fog, ByTheDistanceStaysWhenTheCameraTurns) {
    const glm::dvec3 place(1, 2, -9);
    const Files files = shaded("exp(-.08 * length(vEC.xyz)), exp(-.08 * abs(vEC.z)), 1.");
    std::vector<double> byDepth;
    for (const auto& [x, y] :
         {std::pair(0., 0.), std::pair(2., 1.), std::pair(-2.5, 2.), std::pair(3., 4.5)}) {
        const FloatPicture picture = draw(
            fmt::format("WindowSize 64 64\nBackground 0\nPerspective 70 .1 100\nLookAt 0 0 0 {} {} -9 0 1 "
                        "0\n{}glBegin points\nglVertex {} {} {}\nglEnd\n",
                        x, y, kProgram, place.x, place.y, place.z),
            files);
        std::size_t points = 0;
        for (int i = 0; i < 64 * 64; ++i) {
            const auto seen = picture.at(i % 64, i / 64);
            if (seen[2] != 1) continue;
            ++points;
            EXPECT_NEAR(static_cast<double>(seen[0]), std::exp(-.08 * glm::length(place)), 1e-6);
            const glm::dvec3 ahead = glm::normalize(glm::dvec3(x, y, -9));
            EXPECT_NEAR(static_cast<double>(seen[1]), std::exp(-.08 * glm::dot(ahead, place)), 1e-6);
            byDepth.push_back(static_cast<double>(seen[1]));
        }
        EXPECT_EQ(points, 1U);
    }
    const auto [least, most] = std::minmax_element(byDepth.begin(), byDepth.end());
    EXPECT_GT(*most - *least, .01) << "fog by depth does change, so the turns were seen";
}

/// What a shader of the library makes of an even picture: the colour of a pixel in the middle.
std::array<float, 3> ofAnEvenPicture(const std::string& shader, const std::string& values,
                                     const std::string& color) {
    const FloatPicture picture =
        draw("WindowSize 8 8\nTexture2D even 8 8 rgba32f nearest clamp\nFragment f.frag\nProgram P " +
                 values + "\nPass even clear {" + color + " 1}\nEndPass\nFill window with P\n",
             {{"f.frag", shipped(shader)}});
    return picture.width == 8 ? picture.at(4, 4) : std::array<float, 3>{-1, -1, -1};
}

TEST(ImageWeights, BlurAnEvenPictureToItselfAndFindNoEdgeInIt) {
    const std::string filter = "uInUnit even uTSharp 0 uTEdge 1 uEdgeDetect ";
    const auto blurred = ofAnEvenPicture("texture/filter.frag", filter + "false", ".3 .6 .9");
    const auto edges = ofAnEvenPicture("texture/filter.frag", filter + "true", ".3 .6 .9");
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(blurred[i], .3 * static_cast<double>(i + 1), 1e-6);
        EXPECT_NEAR(edges[i], 0, 1e-6);
    }
}

TEST(ImageWeights, OfTheLuminanceAddUpToOne) {
    const std::string grey = "uImageUnit even uNegative 0 uBrightness 1 uContrast 1 uSaturation 0";
    double sum = 0;
    for (const char* each : {"1 0 0", "0 1 0", "0 0 1"})
        sum += ofAnEvenPicture("image/adjust.frag", grey, each)[0];
    EXPECT_NEAR(sum, 1, 1e-6);
    EXPECT_NEAR(ofAnEvenPicture("image/adjust.frag", grey, ".37 .37 .37")[2], .37, 1e-6);
}

}  // namespace
}  // namespace glibra::stress
