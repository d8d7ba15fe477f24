// Adjacent triangles cover every pixel once, without gap or overlap, and two passes have equal depths
// (exercises' accuracy table 8; NM39).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "support.h"

namespace glibra::stress {
namespace {

constexpr int kTransforms = 10'000;

std::string randomAxis(std::uint32_t seed) {
    return fmt::format("{} {} {}", spread(seed), spread(seed + 1), spread(seed + 2));
}

/// 100 x 100 closed meshes, each in its own cell, randomly turned, stretched and often mirrored.
std::string closedMeshes(const std::string& view) {
    constexpr std::array kShapes{"Sphere .6 12 8", "Box .7 .7 .7", "Cylinder .4 .6 14 2", "Cone .5 .7 12 3",
                                 "Sphere .6 31 17"};
    std::string scene = "WindowSize 1600 1600\nBackground 0\n" + view + kProgram;
    for (std::uint32_t i = 0; i < kTransforms; ++i) {
        const std::uint32_t n = 20 * i;
        const auto factor = [&](std::uint32_t k) {
            const double value = spread(n + k);
            return (value < 0 ? -1 : 1) * (.02 + .65 * std::abs(value));
        };
        const std::uint32_t column = i % 100;
        const std::uint32_t row = i / 100;
        scene += fmt::format(
            "PushMatrix\nTranslate {} {} 0\nRotate {} {}\nScale {} {} {}\nRotate {} {}\n{}\nPopMatrix\n",
            column + .5 + .1 * spread(n), row + .5 + .1 * spread(n + 1), 180 * spread(n + 2),
            randomAxis(n + 3), factor(6), factor(7), factor(8), 180 * spread(n + 9), randomAxis(n + 10),
            kShapes[i % kShapes.size()]);
    }
    return scene;
}

const Files kCountFacings{
    {"v.vert", "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
    {"f.frag", addingFragment("gl_FrontFacing ? 1. : 0., gl_FrontFacing ? 0. : 1., 0.")}};

void expectClosed(const FloatPicture& picture) {
    ASSERT_EQ(picture.width, 1600);
    // A closed mesh has no boundary, so front and back faces cover every pixel exactly equally often.
    EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] != rgb[1]; }), 0U);
    // The meshes are convex, so a ray enters once. Rounding to the rasteriser's grid may fold a sliver at the
    // outline.
    const std::size_t twice = picture.count([](const auto& rgb) { return rgb[0] > 1; });
    const std::size_t once = picture.count([](const auto& rgb) { return rgb[0] == 1; });
    EXPECT_GT(once, 1600U * 1600 / 20);
    EXPECT_LT(twice, once / 10'000);
    std::printf("%zu pixels covered once, %zu twice\n", once, twice);
}

TEST(ClosedMeshes, CoverEachPixelOnceUnderTenThousandTransforms) {
    expectClosed(draw(closedMeshes("Ortho 0 100 0 100\nLookAt 0 0 50 0 0 0 0 1 0\n"), kCountFacings));
}

TEST(ClosedMeshes, CoverEachPixelOnceInPerspective) {
    expectClosed(
        draw(closedMeshes("Perspective 90 .1 1000\nLookAt 50 50 49 50 50 0 0 1 0\n"), kCountFacings));
}

TEST(OpenSheets, CoverEachPixelOnceUnderTenThousandTransforms) {
    // Sheets that reach beyond the window in all directions, drawn over each other. Each adds 1 to red and
    // its own number to green, so that a pixel that one sheet misses and another hits twice is detected.
    for (const char* view : {"Ortho -1 1 -1 1\n", "Perspective 50 .1 1000\n"}) {
        std::string scene = "WindowSize 64 64\nBackground 0\n" + std::string(view) + kProgram;
        double weights = 0;
        for (std::uint32_t i = 0; i < kTransforms; ++i) {
            const std::uint32_t n = 700'000 + 20 * i;
            const double weight = i % 1009 / 1024.;
            weights += weight;
            // A sheet of size 40 at distance 4 covers the view if it is tilted by at most 35 degrees.
            scene += fmt::format(
                "Color {} 0 0\nPushMatrix\nTranslate {} {} -4\nRotate {} {} {} 0\nRotate {} 0 0 1\nScale {} "
                "{} 1\n"
                "QuadXY 0 40 {} {}\nPopMatrix\n",
                weight, spread(n), spread(n + 1), 35 * spread(n + 2), spread(n + 3), spread(n + 4),
                180 * spread(n + 5), 1 + std::abs(spread(n + 6)), -1 - 2 * std::abs(spread(n + 7)),
                3 + i % 17, 2 + i % 23);
        }
        const FloatPicture picture =
            draw(scene, {{"v.vert",
                          "#version 330 core\nflat out float vWeight;\nvoid main() {\n  vWeight = aColor.r;\n"
                          "  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
                         {"f.frag", addingFragment("1., vWeight, 0.", "flat in float vWeight;\n")}});
        ASSERT_EQ(picture.width, 64);
        const std::size_t wrong = picture.count([&](const auto& rgb) {
            return rgb[0] != static_cast<float>(kTransforms) || rgb[1] != static_cast<float>(weights);
        });
        EXPECT_EQ(wrong, 0U) << view;
    }
}

/// Draws everything with `first` in red, then again with `second` in green. Returns the number of pixels that
/// stay red because the second pass is deeper there, if only by one bit.
std::size_t deeperInSecondPass(const std::string& first, const std::string& second) {
    std::string shapes;
    for (std::uint32_t i = 0; i < 60; ++i)
        shapes += fmt::format("PushMatrix\nTranslate {} {} {}\nRotate {} {}\nScale {} 1 {}\n{}\nPopMatrix\n",
                              2 * spread(30 * i), 2 * spread(30 * i + 1), 2 * spread(30 * i + 2),
                              180 * spread(30 * i + 3), randomAxis(30 * i + 4), .4 + spread(30 * i + 7) / 3,
                              .4 + spread(30 * i + 8) / 3,
                              i % 3 == 0   ? "Torus .6 .2 12 24"
                              : i % 3 == 1 ? "Sphere .6 24 12"
                                           : "Teapot");
    const FloatPicture picture = draw(
        "WindowSize 400 400\nBackground 0\nPerspective 45 .1 100\nLookAt 1 2 6 0 0 0 0 1 0\nVertex "
        "a.vert\nFragment "
        "red.frag\nProgram A\n" +
            shapes + "Vertex b.vert\nFragment green.frag\nProgram B\n" + shapes,
        {{"a.vert", first},
         {"b.vert", second},
         {"red.frag",
          "#version 330 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1., 0., 0., 1.); }\n"},
         {"green.frag",
          "#version 330 core\nin vec3 vN;\nin vec3 vL;\nout vec4 fColor;\n"
          "void main() { fColor = vec4(0., 1., .001 * dot(normalize(vN), normalize(vL)), 1.); }\n"}});
    EXPECT_GT(picture.count([](const auto& rgb) { return rgb[0] + rgb[1] > 0; }), 20'000U);
    return picture.count([](const auto& rgb) { return rgb[0] != 0; });
}

std::string plain(const std::string& position) {
    return "#version 330 core\nvoid main() { gl_Position = " + position + "; }\n";
}
std::string lit(const std::string& position) {
    return "#version 330 core\nout vec3 vN;\nout vec3 vL;\nvoid main() {\n  vec4 ec = uModelViewMatrix * "
           "aVertex;\n"
           "  vN = normalize(uNormalMatrix * aNormal);\n  vL = vec3(3., 4., 5.) - ec.xyz;\n  gl_Position = " +
           position + ";\n}\n";
}

TEST(TwoPasses, WithTheSameExpressionHaveTheSameDepth) {
    const std::string product = "uModelViewProjectionMatrix * aVertex";
    EXPECT_EQ(deeperInSecondPass(plain(product), lit(product)), 0U);
    // The first pass is not deeper either, so the depths are equal.
    EXPECT_EQ(deeperInSecondPass(
                  "#version 330 core\nout vec3 vN;\nout vec3 vL;\nvoid main() {\n  vec4 ec = "
                  "uModelViewMatrix * aVertex;\n  vN = ec.xyz;\n  vL = ec.zxy;\n  gl_Position = " +
                      product + ";\n}\n",
                  "#version 330 core\nout vec3 vN;\nout vec3 vL;\nvoid main() { vN = vL = vec3(1.);  "
                  "gl_Position = " +
                      product + ";\n}\n"),
              0U);
}

TEST(TwoPasses, OfOldAndNewSpellingHaveTheSameDepth) {
    const std::string old =
        "varying vec3 vN;\nvarying vec3 vL;\nvoid main() {\n  vN = gl_Normal;\n  vL = gl_Vertex.xyz;\n";
    const std::string product = "uModelViewProjectionMatrix * aVertex";
    for (const std::string& position :
         {std::string("ftransform()"), std::string("gl_ModelViewProjectionMatrix * gl_Vertex")}) {
        EXPECT_EQ(deeperInSecondPass(plain(product),
                                     fmt::format("#version 120\n{}  gl_Position = {};\n}}\n", old, position)),
                  0U)
            << position;
        EXPECT_EQ(
            deeperInSecondPass(fmt::format("#version 120\nvoid main() {{ gl_Position = {}; }}\n", position),
                               lit(product)),
            0U)
            << position;
    }
}

TEST(TwoPasses, WithTheBuiltInProgramHaveTheSameDepth) {
    // The first pass has flat colours and no program; the lit pass is drawn over it.
    const std::string view =
        "WindowSize 300 300\nBackground 0\nPerspective 45 .1 100\nLookAt 1 2 6 0 0 0 0 1 0\n";
    const std::string shape = "Rotate 33 1 2 3\nScale 1 .7 1.3\nTeapot\n";
    const FloatPicture picture =
        draw(view + "Color 1 0 0\n" + shape + "LookAt 1 2 6 0 0 0 0 1 0\n" + kProgram + shape,
             shaded("vec3(0., 1., 0.)"));
    EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] != 0; }), 0U);
    EXPECT_GT(picture.count([](const auto& rgb) { return rgb[1] != 0; }), 5'000U);
}

TEST(TwoPasses, WithOtherArithmeticDiffer) {
    // This shows that the check can fail: products in another order give different depths at some pixels.
    const std::size_t differing = deeperInSecondPass(plain("uModelViewProjectionMatrix * aVertex"),
                                                     lit("uProjectionMatrix * (uModelViewMatrix * aVertex)"));
    EXPECT_GT(differing, 0U);
    RecordProperty("pixels", static_cast<int>(differing));
}

}  // namespace
}  // namespace glibra::stress
