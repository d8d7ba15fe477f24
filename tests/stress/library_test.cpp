// The library's shaders compared with closed forms: contours of negative values (NM21), parity of large
// floats (NM23), silhouettes in perspective (NM30), normals along a bent tube (NM35), and the angles of the
// rainbow (NM44).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support.h"

namespace glibra::stress {
namespace {

/// The colour ramp from blue over cyan, green and yellow to red.
std::array<double, 3> ramp(double t) {
    const double band = 4 * std::clamp(t, 0., 1.);
    return {std::clamp(band - 2, 0., 1.), std::clamp(2 - std::abs(band - 2), 0., 1.),
            std::clamp(2 - band, 0., 1.)};
}

std::string withRamp(const std::string& path) {
    return replaced(shipped(path), "#include \"../common/rainbow.glsl\"", shipped("common/rainbow.glsl"));
}

TEST(Contours, OfNegativeValuesLieWhereThoseOfPositiveOnesDo) {
    constexpr int kColumns = 450;
    const std::string fragment =
        replaced(withRamp("visualization/cutting_plane.frag"), "texture(uTexUnit, stp).r", "45. * vModel.x");
    for (const double half : {1., 4., 4.9}) {
        const FloatPicture picture = draw(
            fmt::format("WindowSize {0} {0}\n{1}Program P uZ 0 uMin -100 uMax 100 uTol {2}\nQuadXY 0 1\n",
                        kColumns, kFlatView, half),
            {{"v.vert", shipped("visualization/cutting_plane.vert")}, {"f.frag", fragment}});
        ASSERT_EQ(picture.width, kColumns);
        for (int x = 0; x < kColumns; ++x) {
            const double value = 45 * (2 * (x + .5) / kColumns - 1);
            const double off = std::abs(value - 10 * std::round(value / 10));
            if (std::abs(off - half) < 1e-3) continue;
            const auto seen = picture.at(x, 7);
            // The ramp's largest component is 1 everywhere.
            EXPECT_NEAR(static_cast<double>(std::max({seen[0], seen[1], seen[2]})), off < half ? .35 : 1,
                        1e-6)
                << value;
        }
    }
}

TEST(CircleSquared, HasTheParityOfTheRoundedSquare) {
    constexpr int kSide = 300;
    for (const float side : {.875F, 1.F, 1.08F}) {
        const FloatPicture picture =
            draw(fmt::format("WindowSize {0} {0}\n{1}Program P uSide {2}\nQuadXY 0 1\n", kSide, kFlatView,
                             number(static_cast<double>(side))),
                 {{"v.vert", shipped("effects/circle_squared.vert")},
                  {"f.frag", shipped("effects/circle_squared.frag")}});
        ASSERT_EQ(picture.width, kSide);
        std::size_t wrong = 0;
        std::size_t open = 0;
        for (int row = 0; row < kSide; ++row)
            for (int column = 0; column < kSide; ++column) {
                const float x = side * (static_cast<float>(column) + .5F);
                const float y = side * (static_cast<float>(kSide - 1 - row) + .5F);
                // Drivers may fuse the multiplication and the addition or not.
                const volatile float xx = x * x;
                const volatile float yy = y * y;
                const int counts[] = {static_cast<int>(xx + yy), static_cast<int>(std::fma(x, x, yy)),
                                      static_cast<int>(std::fma(y, y, xx))};
                const auto seen = picture.at(column, row);
                const bool isDrawn = std::max({seen[0], seen[1], seen[2]}) > 0;
                wrong += std::none_of(std::begin(counts), std::end(counts),
                                      [&](int each) { return (each % 2 == 0) == isDrawn; })
                             ? 1
                             : 0;
                open += counts[0] != counts[1] || counts[0] != counts[2] ? 1 : 0;
            }
        EXPECT_EQ(wrong, 0U) << side;
        EXPECT_LT(open, std::size_t{kSide} * kSide / 50) << "rounding decides few pixels";
    }
}

/// A closed sphere as OBJ text. Each vertex occurs once.
std::string objSphere(int slices, int stacks) {
    std::string text = "v 0 1 0\n";
    for (int j = 1; j < stacks; ++j)
        for (int i = 0; i < slices; ++i) {
            const double polar = std::numbers::pi * j / stacks;
            const double around = 2 * std::numbers::pi * i / slices;
            text += fmt::format("v {} {} {}\n", std::sin(polar) * std::sin(around), std::cos(polar),
                                std::sin(polar) * std::cos(around));
        }
    text += "v 0 -1 0\n";
    const auto index = [&](int j, int i) { return 2 + (j - 1) * slices + i % slices; };
    const int last = 2 + (stacks - 1) * slices;
    for (int i = 0; i < slices; ++i) {
        text += fmt::format("f 1 {} {}\n", index(1, i), index(1, i + 1));
        for (int j = 1; j + 1 < stacks; ++j)
            text += fmt::format("f {0} {1} {2}\nf {0} {2} {3}\n", index(j, i), index(j + 1, i),
                                index(j + 1, i + 1), index(j, i + 1));
        text += fmt::format("f {} {} {}\n", index(stacks - 1, i), last, index(stacks - 1, i + 1));
    }
    return text;
}

/// The number of pixels of `some` that have no pixel of `others` within two pixels.
std::size_t apart(const std::vector<bool>& some, const std::vector<bool>& others, int side) {
    std::size_t count = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            if (!some[static_cast<std::size_t>(y * side + x)]) continue;
            bool near = false;
            for (int v = std::max(0, y - 2); v <= std::min(side - 1, y + 2); ++v)
                for (int u = std::max(0, x - 2); u <= std::min(side - 1, x + 2); ++u)
                    near = near || others[static_cast<std::size_t>(v * side + u)];
            count += near ? 0 : 1;
        }
    return count;
}

TEST(Silhouettes, LieOnTheOutlineInAWideView) {
    constexpr int kSide = 160;
    const std::string view = fmt::format(
        "WindowSize {0} {0}\nBackground 0\nPerspective 100\nLookAt 0 0 2.6 1.3 .8 0 0 1 0\n", kSide);
    const std::string ball = objSphere(24, 16);
    const FloatPicture body = draw(view + kProgram + "Obj ball.obj\n", [&] {
        Files files = shaded("vec3(1.)");
        files["ball.obj"] = ball;
        return files;
    }());
    const auto lines = [&](const std::string& geometry) {
        return draw(view +
                        "Vertex v.vert\nGeometry g.geom\nFragment f.frag\nProgram P uInk {1 1 1}\nObjAdj "
                        "ball.obj\n",
                    {{"v.vert", shipped("geometry/silhouette.vert")},
                     {"g.geom", geometry},
                     {"f.frag", shipped("geometry/silhouette.frag")},
                     {"ball.obj", ball}});
    };
    ASSERT_EQ(body.width, kSide);
    const auto covered = [&](int x, int y) {
        return x < 0 || y < 0 || x >= kSide || y >= kSide || body.at(x, y)[0] > 0;
    };
    std::vector<bool> outline;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            outline.push_back(covered(x, y) && !(covered(x - 1, y) && covered(x + 1, y) &&
                                                 covered(x, y - 1) && covered(x, y + 1)));
    const auto inked = [&](const FloatPicture& picture) {
        std::vector<bool> ink;
        for (int i = 0; i < kSide * kSide; ++i) ink.push_back(picture.at(i % kSide, i / kSide)[0] > 0);
        return ink;
    };
    const std::string shader = shipped("geometry/silhouette.geom");
    const std::vector<bool> ink = inked(lines(shader));
    EXPECT_GT(std::count(ink.begin(), ink.end(), true), 100);
    EXPECT_EQ(apart(ink, outline, kSide), 0U);
    EXPECT_EQ(apart(outline, ink, kSide), 0U);
    // The sign of the normal's z is correct only in parallel projection. In perspective it gives other lines.
    const std::vector<bool> byNormal =
        inked(lines(replaced(shader, "dot(cross(b - a, c - a), a) < 0.", "cross(b - a, c - a).z > 0.")));
    EXPECT_GT(apart(byNormal, outline, kSide), 50U);
}

/// The share of the bent arrow's triangles whose normal is within 14 degrees of the normals at their corners.
double smoothShare(const std::string& vertex) {
    const FloatPicture picture = draw(
        "WindowSize 128 128\nBackground 0\nLookAt 0 0 0 0 0 -1 0 1 0\nVertex v.vert\nGeometry "
        "g.geom\nFragment f.frag\nProgram P uN 2.2 uK 2.4 uPeristaltic 3 uSpeed 0 uPhase .5\nXarrow 200\n",
        {{"v.vert", vertex},
         {"g.geom",
          "#version 330 core\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\n"
          "in vec3 vPosition[], vNormal[];\nflat out float gLeast;\nvoid main() {\n"
          "  vec3 face = normalize(cross(vPosition[1] - vPosition[0], vPosition[2] - vPosition[0]));\n"
          "  gLeast = 1.;\n"
          "  for (int i = 0; i < 3; ++i) gLeast = min(gLeast, dot(face, normalize(vNormal[i])));\n"
          "  vec2 pixel = vec2(gl_PrimitiveIDIn % 128, gl_PrimitiveIDIn / 128);\n"
          "  gl_Position = vec4((pixel + .5) / 64. - 1., 0., 1.);\n  EmitVertex();\n  EndPrimitive();\n}\n"},
         {"f.frag", addingFragment("gLeast > .97 ? 1. : 0., 1., 0.", "flat in float gLeast;\n")}});
    EXPECT_GT(picture.sum(1), 9000);
    return picture.sum(0) / picture.sum(1);
}

TEST(BentArrow, HasTheNormalsOfItsSurface) {
    const std::string vertex = shipped("visualization/arrow.vert");
    const double share = smoothShare(vertex);
    EXPECT_GT(share, .98);
    // Normals that are only turned with the frame ignore the bulge.
    const double byFrame = smoothShare(
        replaced(vertex, "uNormalMatrix * bent",
                 "uNormalMatrix * (aNormal.x * tangent + aNormal.y * normal + aNormal.z * binormal)"));
    EXPECT_LT(byFrame, share - .01);
}

TEST(Rainbow, RunsFromVioletAtFortyToRedAtFortyTwoDegrees) {
    constexpr int kSide = 600;
    const std::string fragment =
        replaced(withRamp("effects/rainbow.frag"), "texture(uImageUnit, vST).rgb", "vec3(0.)");
    const FloatPicture picture = draw(
        fmt::format("WindowSize {0} {0}\n{1}Program P uUpDown .5 uLeftRight 0 uInOut 1 uAlf 1\nQuadXY 0 1\n",
                    kSide, kFlatView),
        {{"v.vert", shipped("effects/rainbow.vert")}, {"f.frag", fragment}});
    ASSERT_EQ(picture.width, kSide);
    const auto smooth = [](double low, double high, double x) {
        const double t = std::clamp((x - low) / (high - low), 0., 1.);
        return t * t * (3 - 2 * t);
    };
    std::size_t colored = 0;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            const double x = 2 * (column + .5) / kSide - 1;
            const double y = 1 - 2 * (row + .5) / kSide;
            if (y < .2) continue;  // no sky
            const double angle = std::atan(std::hypot(x, y - .5)) / kDegree;
            const auto seen = picture.at(column, row);
            const double bow = smooth(39.5, 40.5, angle) * (1 - smooth(41.5, 42.5, angle));
            const double inside = .12 * smooth(20, 40, angle) * (1 - smooth(40, 41, angle));
            const auto color = ramp((angle - 40) / 2);
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(static_cast<double>(seen[k]), inside + .75 * bow * color[k], 2e-4) << angle;
            if (angle < 39.4 || angle > 42.6) {
                EXPECT_EQ(seen[0], seen[2]) << "no colour at " << angle;
            } else if (std::abs(angle - 41) > .6 && bow > .1) {
                ++colored;
                EXPECT_EQ(angle > 41, seen[0] > seen[2]) << angle;
            }
        }
    EXPECT_GT(colored, 1000U);
}

}  // namespace
}  // namespace glibra::stress
