// What surfaces show, against closed forms (exercises' accuracy table 12, 28, 37, 55): bumps smaller than a
// pixel in motion, culled faces, the stretch of a dome's picture, and a lens that bends straight lines.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "support.h"

namespace glibra::stress {
namespace {

TEST(SmallBumps, ShimmerLessWithTheSamplesPerPixelAsInTheory) {
    // Normals swing with 2.37 waves per pixel and move. The exact picture is the mean over each pixel and
    // hardly changes; what a pixel shows in place of it changes with the wave. The variance over a sequence
    // of pictures is compared with that of the same means in double.
    constexpr int kSide = 32, kMoments = 24;
    constexpr double kWaves = 2.37;
    const auto shine = [](double phase) {
        const double slope = .6 * std::cos(2 * std::numbers::pi * phase), h = .3;
        const double cosine = (h * slope + std::sqrt(1 - h * h)) / std::sqrt(1 + slope * slope);
        return std::pow(std::max(cosine, 0.), 60.);
    };
    const auto variance = [](const std::vector<double>& values) {
        double mean = 0, squares = 0;
        for (const double each : values) mean += each, squares += each * each;
        mean /= static_cast<double>(values.size());
        return squares / static_cast<double>(values.size()) - mean * mean;
    };
    double first = 0;
    for (const int samples : {1, 2, 4, 8, 64}) {
        std::vector<std::vector<double>> found(kSide), exact(kSide);
        for (int moment = 0; moment < kMoments; ++moment) {
            const double time = moment / 7.3;
            const FloatPicture picture = draw(fmt::format(R"(WindowSize {0} 4
Fragment inline
#version 330 core
uniform float uTime;
uniform int uSamples;
out vec4 fColor;
float shine(float phase) {{
    vec3 n = normalize(vec3(.6 * cos(6.283185307 * phase), 0., 1.)), h = vec3(.3, 0., sqrt(.91));
    return pow(max(dot(n, h), 0.), 60.);
}}
void main() {{
    float sum = 0.;
    for (int i = 0; i < uSamples; ++i)
        sum += shine(fract({1} * (floor(gl_FragCoord.x) + (float(i) + .5) / float(uSamples)) + uTime));
    fColor = vec4(vec3(sum / float(uSamples)), 1.);
}}
EndFragment
Program Bumps uTime ({2}) uSamples {3}
Fill window with Bumps
)",
                                                          kSide, kWaves, number(time), samples));
            ASSERT_EQ(picture.width, kSide);
            for (int column = 0; column < kSide; ++column) {
                found[static_cast<std::size_t>(column)].push_back(
                    static_cast<double>(picture.at(column, 2)[0]));
                double sum = 0;
                for (int i = 0; i < samples; ++i) sum += shine(kWaves * (column + (i + .5) / samples) + time);
                exact[static_cast<std::size_t>(column)].push_back(sum / samples);
            }
        }
        double shown = 0, inTheory = 0;
        for (int column = 0; column < kSide; ++column) {
            shown += variance(found[static_cast<std::size_t>(column)]) / kSide;
            inTheory += variance(exact[static_cast<std::size_t>(column)]) / kSide;
        }
        std::printf("%d samples: variance over time %.6f, in theory %.6f\n", samples, shown, inTheory);
        EXPECT_NEAR(shown, inTheory, .02 * inTheory + 1e-6);
        if (samples == 1) {
            EXPECT_GT(shown, .05);
            first = shown;
        }
        if (samples == 64) {
            EXPECT_LT(shown, first / 100);
        }
    }
}

TEST(CulledFaces, AreHalfOfAClosedMeshAndChangeNoPicture) {
    // A ray that enters a closed mesh leaves it: front and back faces cover each pixel equally often.
    const std::string scene = R"(WindowSize 300 300
Background 0 0 0
Camera eye LookAt 0 0 6  0 0 0  0 1 0  Perspective 50 .1 100
Vertex inline
#version 330 core
in vec3 position;
uniform mat4 mvp;
void main() {{ gl_Position = mvp * vec4(position, 1.); }}
EndVertex
Fragment f.frag
Program Cover
State {}
Group
    Rotate 50 1 2 3
    Torus .5 1.3 40 60
EndGroup
Translate 1 1 0
Sphere .8 40 40
)";
    const Files count{{"f.frag", addingFragment("gl_FrontFacing ? 1. : 0., gl_FrontFacing ? 0. : 1., 0.")}};
    const std::string adds = "depth off  depthwrite off  blend one one  cull ";
    const FloatPicture all = draw(fmt::format(fmt::runtime(scene), adds + "off"), count);
    const FloatPicture front = draw(fmt::format(fmt::runtime(scene), adds + "back"), count);
    const FloatPicture back = draw(fmt::format(fmt::runtime(scene), adds + "front"), count);
    ASSERT_EQ(all.width, 300);
    constexpr double kOnce = 0x1p60;  // what addingFragment() adds for 1
    // A torus and a ball cover tens of thousands of pixels.
    EXPECT_GT(all.sum(0) / kOnce, 10'000);
    EXPECT_EQ(all.sum(0), all.sum(1));
    EXPECT_EQ(front.sum(0), all.sum(0));
    EXPECT_EQ(front.sum(1), 0);
    EXPECT_EQ(back.sum(1), all.sum(1));
    EXPECT_EQ(back.sum(0), 0);
    // With a depth buffer the picture is the same.
    const Files depths{{"f.frag",
                        "#version 330 core\nout vec4 fColor;\n"
                        "void main() { fColor = vec4(vec3(gl_FragCoord.z), 1.); }\n"}};
    const FloatPicture plain = draw(fmt::format(fmt::runtime(scene), "cull off"), depths);
    const FloatPicture culled = draw(fmt::format(fmt::runtime(scene), "cull back"), depths);
    // Not where front and back faces meet in one pixel of the outline: there the nearer one is seen.
    ASSERT_EQ(plain.values.size(), culled.values.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < plain.values.size(); i += 3)
        different += plain.values[i] == culled.values[i] ? 0 : 1;
    std::printf("%.0f front faces, %.0f back faces; %zu pixels differ\n", all.sum(0) / kOnce,
                all.sum(1) / kOnce, different);
    EXPECT_LT(different, 300U);
}

TEST(DomePicture, StretchesTowardThePoleAsTheReciprocalOfTheCosine) {
    // One texel across is as long as the circle of latitude divided by the width: the picture is stretched
    // across by 1 / cos(latitude) against along. Derivatives of a finely divided sphere show it; the pole
    // itself is beyond every bound.
    constexpr int kSide = 400;
    const FloatPicture picture = draw(fmt::format(R"(WindowSize {0} {0}
Camera eye LookAt 0 0 5  0 0 0  0 1 0  Ortho -1 1 -1 1 1 10
Vertex inline
#version 330 core
in vec3 position;
in vec2 texCoord;
uniform mat4 mvp;
out vec3 vPlace;
out vec2 vST;
void main() {{
    vPlace = position;
    vST = texCoord;
    gl_Position = mvp * vec4(position, 1.);
}}
EndVertex
Fragment inline
#version 330 core
in vec3 vPlace;
in vec2 vST;
out vec4 fColor;
void main() {{
    vec3 right = dFdx(vPlace), up = dFdy(vPlace);
    vec3 along = normalize(vec3(vPlace.z, 0., -vPlace.x)), north = normalize(cross(vPlace, along));
    mat2 surface = mat2(dot(right, along), dot(right, north), dot(up, along), dot(up, north));
    mat2 texels = mat2(dFdx(vST), dFdy(vST)) * inverse(surface);
    fColor = vec4(abs(texels[0].x), abs(texels[1].y), vPlace.y, 1.);
}}
EndFragment
Program Stretch
State cull back
Sphere 1 512 256
)",
                                                  kSide));
    ASSERT_EQ(picture.width, kSide);
    double worst = 0, highest = 0;
    int count = 0;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            const double x = (2. * column + 1) / kSide - 1, y = 1 - (2. * row + 1) / kSide;
            // Not at the outline, where a pixel covers much of the surface, nor beyond 80 degrees.
            if (x * x + y * y > .9 * .9 && std::abs(x) > .05) continue;
            if (std::abs(y) > std::sin(80 * kDegree) || x * x + y * y > .995 * .995) continue;
            const auto found = picture.at(column, row);
            const double height = static_cast<double>(found[2]);
            if (std::abs(height) > std::sin(80 * kDegree)) continue;
            const double stretch = 2 * static_cast<double>(found[0]) / static_cast<double>(found[1]);
            // Across, the texture turns once around 2 pi cos; along, once per pi: a factor of 2 at the
            // equator.
            const double expected = 1 / std::sqrt(1 - height * height);
            worst = std::max(worst, std::abs(stretch / expected - 1));
            highest = std::max(highest, stretch);
            ++count;
        }
    std::printf("%d places, stretched by up to %.3f, off by at most %.4f of it\n", count, highest, worst);
    EXPECT_GT(count, kSide * kSide / 3);
    EXPECT_LT(worst, .05);
    EXPECT_GT(highest, 4);
}

TEST(LensCorrection, BendsStraightLinesIntoTheRadialCurve) {
    // Vertical edges at x = c of a picture, through the lens of the headset scene. A pixel at p shows
    // p / (1 + k1 r^2 + k2 r^4), so the edge stands where that has the x of the edge; found by bisection in
    // double.
    constexpr int kWidth = 500, kHeight = 300;
    for (const auto& [k1, k2, zoom] : {std::tuple{-.55, .34, 1.3}, {-.2, 0., 1.}, {-.55, .34, 1.}}) {
        const auto factor = [&, a = k1, b = k2](double r2) { return 1 + a * r2 + b * r2 * r2; };
        const auto source = [&, scale = zoom](double x, double y) {
            const double u = scale * x, v = scale * y;
            return u / factor(u * u + v * v);
        };
        // The factor stays positive up to the corner, so that no place is turned around the middle.
        for (int i = 0; i <= 100; ++i) EXPECT_GT(factor(zoom * zoom * .5 * i / 100.), 0) << i;
        for (const double edge : {-.2, .05, .2}) {
            const Files files{{"lens.frag", shipped("modern/lens.frag")},
                              {"lens.vert", shipped("modern/lens.vert")}};
            const FloatPicture picture =
                draw(fmt::format(R"(WindowSize {0} {1}
Texture2D sheet 4096 16 r32f linear clamp
Fragment inline
#version 330 core
out vec4 fColor;
void main() {{ fColor = vec4(gl_FragCoord.x / 4096. - .5 > {2} ? 1. : 0.); }}
EndFragment
Program Edge
Fill sheet with Edge
Vertex lens.vert
Fragment lens.frag
Program Lens uView sheet uK1 ({3}) uK2 ({4}) uZoom ({5})
Use Lens
FullScreen
)",
                                 kWidth, kHeight, number(edge), number(k1), number(k2), number(zoom)),
                     files);
            ASSERT_EQ(picture.width, kWidth);
            double worst = 0, bend = 0;
            int rows = 0;
            double first = 0;
            for (int row = 0; row < kHeight; ++row) {
                const double y = .5 - (row + .5) / kHeight;
                double low = -.5, high = .5;
                if (source(low, y) > edge || source(high, y) < edge) continue;
                while (high - low > 1e-9)
                    (source((low + high) / 2, y) > edge ? high : low) = (low + high) / 2;
                double dark = 0;  // pixels to the left of the edge
                for (int column = 0; column < kWidth; ++column)
                    dark += 1 - static_cast<double>(picture.at(column, row)[0]);
                if (rows++ == 0) first = low * kWidth;
                worst = std::max(worst, std::abs(dark - (low + .5) * kWidth));
                bend = std::max(bend, std::abs(low * kWidth - first));
            }
            std::printf("edge at %g: bent by up to %.1f pixels, found within %.3f\n", edge, bend, worst);
            EXPECT_GT(rows, kHeight / 2);
            EXPECT_LT(worst, .6);
            EXPECT_GT(bend, std::abs(edge) > .1 ? 3 : .5);
        }
    }
}

}  // namespace
}  // namespace glibra::stress
