// Compares pictures with closed forms: where edges, rows and depths must lie, computed here from the
// projection alone.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

constexpr std::array<int, 3> kBlack{0, 0, 0};

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

/// Shaders that colour by an expression in the fragment stage; vST and vEC are available.
std::map<std::string, std::string> shaded(const std::string& expression) {
    return {
        {"a.vert",
         "#version 330 core\nout vec3 vST;\nout vec3 vEC;\nvoid main() {\n  vST = aTexCoord0.stp;\n  vEC = "
         "(uModelViewMatrix * aVertex).xyz;\n  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
        {"a.frag",
         "#version 330 core\nin vec3 vST;\nin vec3 vEC;\nout vec4 fColor;\nvoid main() { fColor = vec4(" +
             expression + ", 1.); }\n"}};
}
const std::string kProgram = "Vertex a.vert\nFragment a.frag\nProgram P\n";

TEST(AnalyticPicture, SphereSilhouetteHasItsPerspectiveRadius) {
    // A sphere of radius r at distance d is seen under the half angle asin(r / d); the picture's half height
    // is tan(fov / 2).
    for (const double distance : {3.0, 5.0, 11.0}) {
        const Picture seen =
            picture("WindowSize 401 401\nBackground 0\nPerspective 40\nLookAt 0 0 " +
                    std::to_string(distance) + " 0 0 0 0 1 0\nColor 1 1 1\nSphere 1 400 200\n");
        const double tangent = std::tan(std::asin(1 / distance));
        const double radius = tangent / std::tan(radians(20)) * 200.5;
        const double area = countPixels(seen, kWhite);
        // An inscribed polygon of 400 corners loses less than 0.02 pixels of the radius here.
        EXPECT_NEAR(std::sqrt(area / std::numbers::pi), radius, 0.05) << distance;
        int first = 0;
        while (first < 401 && pixel(seen, first, 200) != kWhite) ++first;
        EXPECT_NEAR(200.5 - first, radius, 0.75) << distance;
    }
}

TEST(AnalyticPicture, QuadCoversExactlyThePixelsWhoseCentresItHolds) {
    // Ortho -1..1 on 64 pixels: a half width of .5 covers pixel centres within 16..47, exactly 32 per side.
    const Picture seen = picture(
        "WindowSize 64 64\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 1 0 0 0 0 1 0\nColor 1 1 1\nQuadXY 0 .5 "
        "3 5\n");
    EXPECT_EQ(countPixels(seen, kWhite), 32 * 32);
    EXPECT_EQ(pixel(seen, 16, 16), kWhite);
    EXPECT_EQ(pixel(seen, 47, 47), kWhite);
    EXPECT_EQ(pixel(seen, 15, 16), kBlack);
    EXPECT_EQ(pixel(seen, 48, 47), kBlack);
}

TEST(AnalyticPicture, ALineHalfWayBetweenTwoWidthsIsTheWider) {
    // The four edges of a square of 32 pixels per side: with width w they cover 4 * 32 * w pixels, except for
    // the corners.
    const auto coverage = [](const std::string& width) {
        return countPixels(
            picture("WindowSize 64 64\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 1 0 0 0 0 1 0\n"
                    "Color 1 1 1\nLineWidth " +
                    width + "\nWireCube 1\n"),
            kWhite);
    };
    for (const int width : {1, 2, 3, 4}) {
        EXPECT_NEAR(coverage(std::to_string(width)), 4 * 32 * width, 4 * width * width) << width;
        EXPECT_EQ(coverage(std::to_string(width) + ".5"), coverage(std::to_string(width + 1))) << width;
    }
}

TEST(AnalyticPicture, OrthoKeepsTheBoxUndistortedInAWideWindow) {
    const Picture seen = picture(
        "WindowSize 128 64\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 1 0 0 0 0 1 0\nColor 1 1 1\nQuadXY 0 "
        ".5\n");
    EXPECT_EQ(countPixels(seen, kWhite), 32 * 32);
    EXPECT_EQ(pixel(seen, 48, 16), kWhite);
    EXPECT_EQ(pixel(seen, 47, 16), kBlack);
}

TEST(AnalyticPicture, CheckerboardRowsLieWhereThePerspectiveFormulaPutsThem) {
    // A floor at y = -1 seen from the origin along -z: the row at depth z is seen at pixel 200 (1 + 1 / (|z|
    // tan(fov/2))) from the top. Stripes of width 1 in z change colour at whole z.
    const Picture seen =
        picture("WindowSize 400 400\nBackground 1 0 0\nPerspective 90 .1 1000\nTranslate 0 0 -21\n" +
                    kProgram + "QuadXZ -1 20 1 1\n",
                shaded("vec3(mod(floor(-vEC.z), 2.))"), {.view = ViewPolicy::glman});
    int checked = 0;
    for (int z = 2; z <= 9; ++z) {
        // From the bottom up: all rows strictly between the edges z and z + 1 have the colour of stripe z.
        const double lower = 200 + 200.0 / z;
        const double upper = 200 + 200.0 / (z + 1);
        for (int row = static_cast<int>(std::ceil(upper)); row + 1 <= lower; ++row) {
            const auto expected = z % 2 == 1 ? kWhite : kBlack;
            EXPECT_EQ(pixel(seen, 200, row), expected) << "z " << z << " row " << row;
            ++checked;
        }
    }
    EXPECT_GT(checked, 60);
}

TEST(AnalyticPicture, TextureCoordinatesAreInterpolatedInPerspective) {
    // The same floor, below the origin, where t grows along +z: t = (41 - |z|) / 40 with |z| = 200 / (row -
    // 200).
    RenderOptions options;
    options.floatPixels = true;
    options.view = ViewPolicy::glman;
    const Picture seen = picture(
        "WindowSize 400 400\nPerspective 90 .1 1000\nTranslate 0 0 -21\n" + kProgram + "QuadXZ -1 20 1 1\n",
        shaded("vST"), options);
    ASSERT_TRUE(seen.isFloat);
    GLint subpixelBits = 0;
    ASSERT_TRUE(sharedContext().makeCurrent());
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    for (int row = 206; row < 398; row += 7) {
        const double depth = 200.0 / (row + .5 - 200);
        float t = 0;
        const std::size_t at =
            ((static_cast<std::size_t>(row) * 400 + 200) * static_cast<std::size_t>(seen.components) + 1) *
            sizeof(float);
        std::memcpy(&t, seen.data.data() + at, sizeof t);
        // A driver places vertices on a grid within the pixel, half a step of it away at most.
        const double perPixel = depth / (row + .5 - 200) / 40;
        EXPECT_NEAR(t, (41 - depth) / 40, 2e-5 + perPixel / std::ldexp(2, subpixelBits)) << row;
    }
}

TEST(AnalyticPicture, DepthOfAPlaneFollowsTheProjection) {
    // Window depth of a plane at distance d: (1/near - 1/d) / (1/near - 1/far).
    RenderOptions options;
    options.floatPixels = true;
    for (const double distance : {1.0, 2.0, 7.0, 40.0}) {
        const Picture seen =
            picture("WindowSize 8 8\nPerspective 60 .5 50\nLookAt 0 0 " + std::to_string(distance) +
                        " 0 0 0 0 1 0\n" + kProgram + "QuadXY 0 100\n",
                    shaded("vec3(gl_FragCoord.z)"), options);
        float depth = 0;
        std::memcpy(
            &depth,
            seen.data.data() + (4 * 8 + 4) * static_cast<std::size_t>(seen.components) * sizeof(float),
            sizeof depth);
        EXPECT_NEAR(depth, (2 - 1 / distance) / (2 - 1 / 50.0), 1e-5) << distance;
    }
}

TEST(AnalyticPicture, NearerSurfaceWinsWhateverTheOrder) {
    const std::string far = "Color 1 0 0\nQuadXY -1 10\n";
    const std::string near = "Color 0 1 0\nQuadXY 1 10\n";
    const std::string view = "WindowSize 16 16\nLookAt 0 0 5 0 0 0 0 1 0\n";
    const std::array<int, 3> green{0, 255, 0};
    EXPECT_EQ(countPixels(picture(view + far + near), green), 256);
    EXPECT_EQ(countPixels(picture(view + near + far), green), 256);
}

TEST(AnalyticPicture, EmptySceneIsTheBackground) {
    const Picture seen = picture("WindowSize 30 20\n");
    EXPECT_EQ(seen.width, 30);
    EXPECT_EQ(seen.height, 20);
    EXPECT_EQ(countPixels(seen, {18, 27, 33}), 600);
    EXPECT_EQ(countPixels(picture("WindowSize 30 20\nBackground 1 .2 0\n"), {255, 51, 0}), 600);
}

TEST(AnalyticPicture, BlendingCoversByAlpha) {
    const Picture seen =
        picture("WindowSize 8 8\nBackground 0 0 1\nLookAt 0 0 5 0 0 0 0 1 0\nColor 1 0 0 .25\nQuadXY 0 10\n");
    const auto [red, green, blue] = pixel(seen, 4, 4);
    EXPECT_NEAR(red, 64, 1);
    EXPECT_EQ(green, 0);
    EXPECT_NEAR(blue, 191, 1);
}

TEST(AnalyticPicture, TimerIsTheFractionOfItsPeriod) {
    RenderOptions options;
    options.floatPixels = true;
    for (const double time : {0.0, 3.0, 9.75, 10.0, 1e6 + 2.5}) {
        options.time = time;
        const Picture seen =
            picture("WindowSize 4 4\nTimer 10\nLookAt 0 0 5 0 0 0 0 1 0\n" + kProgram + "QuadXY 0 10\n",
                    shaded("vec3(Timer)"), options);
        float value = 0;
        std::memcpy(&value, seen.data.data(), sizeof value);
        EXPECT_NEAR(value, time / 10 - std::floor(time / 10), 1e-6) << time;
    }
}

TEST(AnalyticPicture, TheEyeMovesBackFromASphereAroundItAndOnlyThen) {
    // Radius 1, 50 degrees: the distance 1 / sin 25 degrees = 2.366, rounded up to sixteenths, is 2.375.
    const std::string scene = "WindowSize 200 200\nBackground 0\nColor 1 1 1\nSphere 1 200 100\n";
    const Picture moved = picture(scene);
    const double tangent = std::tan(std::asin(1 / 2.375));
    EXPECT_NEAR(std::sqrt(countPixels(moved, kWhite) / std::numbers::pi),
                tangent / std::tan(radians(25)) * 100, .1);
    EXPECT_EQ(countPixels(picture(scene, {}, {.view = ViewPolicy::glman}), kWhite), 200 * 200);
}

}  // namespace
}  // namespace glibra::test
