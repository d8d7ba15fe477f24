// Shadow maps against shadows in closed form (exercises' accuracy table 2 to 6): the offset that detaches
// shadows and the one that is too small, lookups beside the map and behind the light, texels, soft edges, and
// a blur whose width is a number instead of texels.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support.h"

namespace glibra::stress {
namespace {

/// A shadow map of the ground y = 0 and an occluder, seen from above.
struct ShadowMap {
    int texels = 256;
    std::string options = "border [1 1 1 1]";
    std::string light;           ///< view and lens of the camera
    std::string occluder;        ///< statements
    std::string state{};         ///< of the pass into the map
    double eyeHalf = 3;          ///< the picture shows x and z from -eyeHalf to eyeHalf
    int pixels = 600;            ///< per side of the picture
    std::string lit;             ///< a GLSL expression of `p`, the place in the map, 0..1
    std::string declarations{};  ///< for it
    std::string tags{};          ///< of the program
};

/// The share of light of every pixel of the ground.
FloatPicture lightOf(const ShadowMap& map) {
    return draw(fmt::format(R"(WindowSize {0} {0}
Camera eye LookAt 0 10 0  0 0 0  0 0 -1  Ortho {1} {2} {1} {2} 1 20
Camera light {3}
Texture2D shadow {4} {4} depth32f nearest {5}
Vertex inline
#version 330 core
in vec3 position;
uniform mat4 mvp;
void main() {{ gl_Position = mvp * vec4(position, 1.); }}
EndVertex
Program Depth
Vertex inline
#version 330 core
in vec3 position;
uniform mat4 mvp, uShadowMatrix;
out vec4 vPlace;
void main() {{
    vPlace = uShadowMatrix * vec4(position, 1.);
    gl_Position = mvp * vec4(position, 1.);
}}
EndVertex
Fragment inline
#version 330 core
uniform sampler2D uShadow;
in vec4 vPlace;
out vec4 fColor;
float stored(vec2 place) {{ return texture(uShadow, place).r; }}
{6}
void main() {{
    vec3 p = vPlace.xyz / vPlace.w;
    fColor = vec4(vec3({7}), 1.);
}}
EndFragment
Program Lit uShadow shadow uShadowMatrix (light.shadow * model) {8}
Pass shadow from light
    Use Depth
    State {9}
    QuadXZ 0 20 1 1
    {10}
EndPass
Use Lit
QuadXZ 0 20 1 1
)",
                            map.pixels, -map.eyeHalf, map.eyeHalf, map.light, map.texels, map.options,
                            map.declarations, map.lit, map.tags, map.state.empty() ? "offset 0 0" : map.state,
                            map.occluder));
}

/// The place on the ground that the centre of a pixel shows.
double groundAt(const ShadowMap& map, int pixel) {
    return map.eyeHalf * ((2. * pixel + 1) / map.pixels - 1);
}

/// The mean light of x0 < x < x1, |z| < half.
double meanLight(const ShadowMap& map, const FloatPicture& picture, double x0, double x1, double half) {
    double sum = 0;
    int count = 0;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const double x = groundAt(map, column), z = groundAt(map, row);
            if (x < x0 || x > x1 || std::abs(z) > half) continue;
            sum += static_cast<double>(picture.at(column, row)[0]);
            ++count;
        }
    return count > 0 ? sum / count : -1;
}

TEST(ShadowOffset, TradesAcneForAGapAsInTheory) {
    // Light comes at 45 degrees, so that depth changes across a texel by the texel's width T. Without an
    // offset the ground shadows half of itself; an offset of B leaves (T/2 - B) / T of it. A wall at x = 0
    // throws its shadow from its foot on, but where the wall is less than B before the ground, the ground is
    // lit: a gap of B / sqrt 2.
    constexpr double kSide = 6, kDepth = 29;
    for (const bool byState : {false, true}) {
        double acneBefore = 1, gapBefore = -1;
        for (const double texelsOfOffset : {0., .125, .25, .52, 1., 4., 16.}) {
            ShadowMap map{.light = "LookAt 10 10 0  0 0 0  0 0 1  Ortho -3 3 -3 3 1 30",
                          .occluder = "QuadYZ 0 1.5 1 1",
                          .lit = "p.z - uBias <= stored(p.xy) ? 1. : 0.",
                          .declarations = "uniform float uBias;"};
            const double texel = kSide / map.texels, bias = texelsOfOffset * texel;
            map.tags = fmt::format("uBias ({})", byState ? "0" : number(bias / kDepth));
            // The factor multiplies the slope of the depth, which is T per texel.
            if (byState) map.state = fmt::format("offset {} 0", number(texelsOfOffset));
            const FloatPicture picture = lightOf(map);
            ASSERT_EQ(picture.width, map.pixels);
            const double acne = 1 - meanLight(map, picture, .3, 2.7, 1.2);
            const double gap = 1.2 * meanLight(map, picture, -1.2, 0, 1.2);
            std::printf("offset of %g texels by %s: acne %.4f of the ground, gap %.4f\n", texelsOfOffset,
                        byState ? "State" : "the shader", acne, gap);
            EXPECT_NEAR(acne, std::max(0., .5 - texelsOfOffset), texelsOfOffset > .5 ? 0 : .02);
            EXPECT_NEAR(gap, bias / std::sqrt(2.), .75 * texel);
            EXPECT_LE(acne, acneBefore);
            if (texelsOfOffset > .5) {
                EXPECT_GE(gap, gapBefore);
            }
            acneBefore = acne;
            gapBefore = gap;
        }
    }
}

/// A light straight above: the place (x, z) of the ground is that of the map.
constexpr const char* kFromAbove = "LookAt 0 10 0  0 0 0  0 0 -1  Ortho -1 1 -1 1 1 20";

TEST(ShadowCoverage, BesideTheMapIsLitRepeatedOrBars) {
    // The map covers |x|, |z| < 1; a beam at |x| < .25, z < 0 crosses its edge. The wrap mode says what a
    // lookup finds outside: the border is lit, clamping continues the edge, repeating the map.
    const auto inBeam = [](double x, double z) { return std::abs(x) < .25 && z < 0; };
    const auto wrapped = [](double v) { return v - 2 * std::floor((v + 1) / 2); };
    for (const std::string options : {"border [1 1 1 1]", "clamp", "repeat"}) {
        const ShadowMap map{.texels = 512,
                            .options = options,
                            .light = kFromAbove,
                            .occluder = "Translate 0 1 -1\nScale .25 1 1\nQuadXZ 0 1 1 1",
                            .lit = "p.z - .001 <= stored(p.xy) ? 1. : 0."};
        const FloatPicture picture = lightOf(map);
        ASSERT_EQ(picture.width, map.pixels);
        int wrong = 0, beside = 0;
        for (int row = 0; row < map.pixels; ++row)
            for (int column = 0; column < map.pixels; ++column) {
                double x = groundAt(map, column), z = groundAt(map, row);
                const bool isOutside = std::max(std::abs(x), std::abs(z)) > 1;
                const double nearEdge = .012;
                if (options == "repeat") x = wrapped(x), z = wrapped(z);
                if (options == "clamp") x = std::clamp(x, -.999, .999), z = std::clamp(z, -.999, .999);
                const bool isAtEdge = std::abs(std::abs(x) - .25) < nearEdge || std::abs(z) < nearEdge ||
                                      std::abs(std::abs(x) - 1) < nearEdge * (options == "clamp" ? 0 : 1) ||
                                      std::abs(std::abs(z) - 1) < nearEdge * (options == "clamp" ? 0 : 1);
                if (isAtEdge) continue;
                const bool isShadow = inBeam(x, z) && !(isOutside && options.starts_with("border"));
                wrong += picture.at(column, row)[0] == (isShadow ? 0.F : 1.F) ? 0 : 1;
                beside += isOutside && isShadow ? 1 : 0;
            }
        std::printf("%s: %d pixels beside the map in shadow\n", options.c_str(), beside);
        EXPECT_EQ(wrong, 0) << options;
        EXPECT_EQ(beside > 0, !options.starts_with("border")) << options;
    }
}

TEST(ShadowCoverage, BehindTheLightIsLitOnlyIfTheShaderAsks) {
    // A light at (0, 1, 0) that looks along -z. What is behind it has w < 0; the division mirrors it into the
    // map, where every depth is less than its own.
    for (const bool asks : {false, true}) {
        ShadowMap map{.light = "LookAt 0 1 0  0 1 -1  0 1 0  Perspective 90 .1 50  aspect 1",
                      .occluder = "Translate 0 1 -2\nQuadXY 0 30 1 1",
                      .lit = "p.z - .001 <= stored(p.xy) ? 1. : 0."};
        if (asks) map.lit = "vPlace.w <= 0. ? 1. : " + map.lit;
        const FloatPicture picture = lightOf(map);
        ASSERT_EQ(picture.width, map.pixels);
        // Seen by the light: |x| < -z and -z > 1, and behind it the mirrored part of the map: |x| < z, z > 1.
        int wrongBehind = 0, behind = 0;
        for (int row = 0; row < map.pixels; ++row)
            for (int column = 0; column < map.pixels; ++column) {
                const double x = groundAt(map, column), z = groundAt(map, row);
                if (z < 1.05 || std::abs(x) > z - .05) continue;
                ++behind;
                wrongBehind += picture.at(column, row)[0] == 1 ? 0 : 1;
            }
        ASSERT_GT(behind, 10'000);
        EXPECT_EQ(wrongBehind, asks ? 0 : behind);
        std::printf("behind the light: %d of %d pixels in shadow\n", wrongBehind, behind);
    }
}

TEST(ShadowTexels, MoveEdgesByTheirSize) {
    // A turned square casts a turned square. The wrong pixels lie along its outline, within half a texel:
    // their area is proportional to the texel, hence to 1 / texels and to the width of what the map covers.
    const double turn = .3;
    const auto wrongShare = [&](int texels, double half) {
        const ShadowMap map{
            .texels = texels,
            .light = fmt::format("LookAt 0 10 0  0 0 0  0 0 -1  Ortho {0} {1} {0} {1} 1 20", -half, half),
            .occluder = fmt::format("Rotate {} 0 1 0\nQuadXZ 1 1.5 1 1", number(turn / kDegree)),
            .lit = "p.z - .001 <= stored(p.xy) ? 1. : 0."};
        const FloatPicture picture = lightOf(map);
        int wrong = 0;
        for (int row = 0; row < picture.height; ++row)
            for (int column = 0; column < picture.width; ++column) {
                const double x = groundAt(map, column), z = groundAt(map, row);
                // Rotate turns x toward -z.
                const double u = std::cos(turn) * x - std::sin(turn) * z,
                             v = std::sin(turn) * x + std::cos(turn) * z;
                const bool isShadow = std::max(std::abs(u), std::abs(v)) < 1.5;
                wrong += picture.at(column, row)[0] == (isShadow ? 0.F : 1.F) ? 0 : 1;
            }
        return static_cast<double>(wrong) / (map.pixels * map.pixels);
    };
    // A point reads the texel whose square it lies in. It is wrong if the edge lies between it and the
    // texel's centre: per length of the edge the mean of |a cos + b sin| for a, b evenly within half a texel.
    const double wide = std::cos(turn) / 2, narrow = std::sin(turn) / 2;
    const double meanDistance = wide / 2 + narrow * narrow / (6 * wide);
    const double outline = 4 * 3., area = 36;
    for (const auto& [texels, half] :
         {std::pair{32, 3.}, {64, 3.}, {128, 3.}, {256, 3.}, {256, 6.}, {256, 12.}, {256, 24.}}) {
        const double texel = 2 * half / texels;
        const double expected = outline * texel * meanDistance / area;
        const double found = wrongShare(texels, half);
        std::printf("%d texels for %g: %.5f of the pixels are wrong, in theory %.5f\n", texels, 2 * half,
                    found, expected);
        EXPECT_NEAR(found / expected, 1, .05) << texels << " " << half;
    }
}

/// The mean of n x n lookups, spread over a square of the side uWidth in the map.
const std::string kMeanOfLookups = R"(uniform float uWidth;
uniform int uGrid;
uniform bool uDither;
float meanLight(vec3 p) {
    float sum = 0.;
    vec2 within = uDither ? (mod(floor(gl_FragCoord.xy), 2.) - .5) / (2. * uGrid) : vec2(0.);
    for (int i = 0; i < uGrid; ++i)
        for (int j = 0; j < uGrid; ++j) {
            vec2 place = (vec2(i, j) + .5) / uGrid - .5 + within;
            sum += p.z - .001 <= stored(p.xy + uWidth * place) ? 1. : 0.;
        }
    return sum / (uGrid * uGrid);
})";

ShadowMap softEdge(double width, int grid, bool dithers) {
    return {.texels = 4096,
            .light = kFromAbove,
            .occluder = "Translate -2 1 0\nQuadXZ 0 2 1 1",  // the edge is x = 0
            .eyeHalf = .2,
            .pixels = 400,
            .lit = "meanLight(p)",
            .declarations = kMeanOfLookups,
            .tags = fmt::format("uWidth ({}) uGrid {} uDither {}", number(width / 2), grid,
                                dithers ? "true" : "false")};
}

TEST(ShadowSamples, ComeCloserToAnAreaLightWithTheirNumber) {
    // Above the edge of an occluder at the height h, a square light of the half angle a is hidden in the
    // share 1/2 - x / (2 h tan a): a ramp as wide as 2 h tan a. n lookups across give n + 1 steps, which are
    // off by up to 1 / (2 n) evenly: 1 / (n sqrt 12) in the root of the mean square.
    constexpr double kWidth = .2;
    const auto rootMeanSquare = [&](int grid, bool dithers, bool meansOfFour) {
        const ShadowMap map = softEdge(kWidth, grid, dithers);
        const FloatPicture picture = lightOf(map);
        double sum = 0;
        int count = 0;
        for (int row = 0; row + 1 < picture.height; row += 2)
            for (int column = 0; column + 1 < picture.width; column += 2) {
                const double x = groundAt(map, column) + .5 * (groundAt(map, 1) - groundAt(map, 0));
                if (std::abs(x) > kWidth / 2) continue;
                double found = static_cast<double>(picture.at(column, row)[0]);
                if (meansOfFour)
                    found = (found + static_cast<double>(picture.at(column + 1, row)[0]) +
                             static_cast<double>(picture.at(column, row + 1)[0]) +
                             static_cast<double>(picture.at(column + 1, row + 1)[0])) /
                            4;
                const double error = found - (.5 + x / kWidth);
                sum += error * error;
                ++count;
            }
        return std::sqrt(sum / count);
    };
    for (const int grid : {1, 2, 4, 8}) {
        const double found = rootMeanSquare(grid, false, false), expected = 1 / (grid * std::sqrt(12.));
        std::printf("%d lookups: off by %.4f, in theory %.4f\n", grid * grid, found, expected);
        EXPECT_NEAR(found / expected, 1, .08) << grid;
    }
    // Four lookups that change from pixel to pixel are as good as sixteen in the mean of four pixels, and
    // show a pattern of 2 x 2 pixels.
    const double single = rootMeanSquare(2, true, false), mean = rootMeanSquare(2, true, true);
    std::printf("4 dithered lookups: off by %.4f, in the means of four pixels by %.4f\n", single, mean);
    EXPECT_NEAR(mean * 4 * std::sqrt(12.), 1, .15);
    EXPECT_GT(single, 1.8 * mean);
}

TEST(ShadowBlur, KeepsItsWidthOnlyIfItIsNotCountedInTexels) {
    // A blur of 10 texels halves when the map doubles. One of .001 of the map per texel, as for a map of 1000
    // texels, keeps its width, whatever the map has, and so is no blur of 10 texels.
    for (const int texels : {512, 1024, 2048})
        for (const bool isCounted : {false, true}) {
            const double side = 2, width = 10 * side * (isCounted ? 1. / texels : .001);
            ShadowMap map = softEdge(width, 8, false);
            map.texels = texels;
            map.eyeHalf = .05;
            const FloatPicture picture = lightOf(map);
            ASSERT_EQ(picture.width, map.pixels);
            // For a ramp the integral of 6 v (1 - v) is its width.
            double found = 0;
            for (int column = 0; column < picture.width; ++column) {
                const double v = static_cast<double>(picture.at(column, picture.height / 2)[0]);
                found += 6 * v * (1 - v) * 2 * map.eyeHalf / map.pixels;
            }
            std::printf("map of %d: penumbra %.5f, stated %.5f\n", texels, found, width);
            EXPECT_NEAR(found, width, 1.5 * side / texels + .02 * width);
        }
}

}  // namespace
}  // namespace glibra::stress
