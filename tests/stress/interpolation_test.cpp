// Interpolation, and vector functions at the limits of their domains: smooth, noperspective and flat varyings
// (exercises' accuracy table 9; NM02, NM32), refraction below and above the critical angle (table 42; NM24),
// and a curve before and after the projection (NM10).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support.h"

namespace glibra::stress {
namespace {

/// A sheet that covers the window, with w = 1 on the left and w = 4 on the right. vAlong goes from 0 to 1.
FloatPicture recedingSheet(const std::string& qualifier) {
    const Files files{{"v.vert", fmt::format("#version 330 core\n{} out float vAlong;\nvoid main() {{\n"
                                             "  float w = aVertex.x < 0. ? 1. : 4.;\n"
                                             "  vAlong = aVertex.x < 0. ? 0. : 1.;\n"
                                             "  gl_Position = vec4(sign(aVertex.xy) * w, 0., w);\n}}\n",
                                             qualifier)},
                      {"f.frag", fmt::format("#version 330 core\n{} in float vAlong;\nout vec4 fColor;\n"
                                             "void main() {{ fColor = vec4(vAlong, 0., 0., 1.); }}\n",
                                             qualifier)}};
    return draw("WindowSize 64 4\n" + kFrontView + kProgram + "QuadXY 0 1 1 1\n", files);
}

TEST(InterpolatedVaryings, FollowThePerspectiveUnlessDeclaredNoperspective) {
    const FloatPicture smooth = recedingSheet("smooth"), plain = recedingSheet("noperspective");
    ASSERT_EQ(smooth.width, 64);
    ASSERT_EQ(plain.width, 64);
    double apart = 0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 64; ++x) {
            const double u = (x + .5) / 64;
            const double inPerspective = u / 4 / ((1 - u) + u / 4);
            EXPECT_NEAR(static_cast<double>(smooth.at(x, y)[0]), inPerspective, 2e-6) << x;
            EXPECT_NEAR(static_cast<double>(plain.at(x, y)[0]), u, 2e-6) << x;
            apart = std::max(apart, std::abs(u - inPerspective));
        }
    EXPECT_GT(apart, .3) << "the qualifier must matter";
}

TEST(FlatVaryings, AreThoseOfTheLastVertexOfEachTriangle) {
    const Files files{{"v.vert",
                       "#version 330 core\nflat out vec3 vColor;\nvoid main() {\n"
                       "  vColor = aColor.rgb;\n  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
                      {"f.frag",
                       "#version 330 core\nflat in vec3 vColor;\nout vec4 fColor;\n"
                       "void main() { fColor = vec4(vColor, 1.); }\n"}};
    const auto picture = [&](const std::string& topology, const std::string& vertices) {
        return draw("WindowSize 64 64\nOrtho 0 4 0 4\n" + kFrontView + kProgram + "glBegin " + topology +
                        "\n" + vertices + "glEnd\n",
                    files);
    };
    const auto vertex = [](double red, double x, double y) {
        return fmt::format("Color {} 0 0\nglVertex {} {} 0\n", red, x, y);
    };
    // Two triangles side by side. Their middles are read, at (x, y) in units of the window.
    const auto redAt = [](const FloatPicture& seen, double x, double y) {
        return seen.at(static_cast<int>(x * 16), 63 - static_cast<int>(y * 16))[0];
    };
    const FloatPicture separate =
        picture("triangles", vertex(.25, 0, 0) + vertex(.5, 2, 0) + vertex(.75, 0, 2) + vertex(1, 2, 0) +
                                 vertex(.375, 4, 0) + vertex(.125, 2, 2));
    ASSERT_EQ(separate.width, 64);
    EXPECT_EQ(redAt(separate, .5, .5), .75F);
    EXPECT_EQ(redAt(separate, 2.5, .5), .125F);
    // The triangles are (0, 1, 2) and (1, 3, 2). Flat varyings come from the newest vertex of each: 2 and 3.
    const FloatPicture strip =
        picture("triangle_strip", vertex(.25, 0, 0) + vertex(.5, 2, 0) + vertex(.75, 0, 2) + vertex(1, 2, 2));
    ASSERT_EQ(strip.width, 64);
    EXPECT_EQ(redAt(strip, .5, .5), .75F);
    EXPECT_EQ(redAt(strip, 1.5, 1.5), 1);
    const FloatPicture fan =
        picture("triangle_fan", vertex(.25, 0, 0) + vertex(.5, 2, 0) + vertex(.75, 2, 2) + vertex(1, 0, 2));
    ASSERT_EQ(fan.width, 64);
    EXPECT_EQ(redAt(fan, 1.5, .5), .75F);
    EXPECT_EQ(redAt(fan, .5, 1.5), 1);
}

TEST(Refraction, KeepsSnellsLawAndIsZeroBeyondTheCriticalAngle) {
    // Columns are angles of incidence from 0 to 90 degrees for rays that leave glass of this ratio.
    for (const double ratio : {1.1, 1.4, 1.5}) {
        const FloatPicture picture =
            draw("WindowSize 256 1\n" + kFrontView + "Vertex v.vert\nFragment f.frag\nProgram P uRatio " +
                     number(ratio) + "\nQuadXY 0 1000\n",
                 shaded("refracted()",
                        "uniform float uRatio;\nvec3 refracted() {\n"
                        "  float a = gl_FragCoord.x / 256. * 1.5707963;\n"
                        "  return refract(vec3(sin(a), -cos(a), 0.), vec3(0., 1., 0.), uRatio);\n}\n"));
        ASSERT_EQ(picture.width, 256);
        EXPECT_EQ(picture.nonFinite(), 0U);
        int total = 0;
        for (int x = 0; x < 256; ++x) {
            const double sine = std::sin((x + .5) / 256 * std::asin(1.));
            const double out = ratio * sine;
            const auto seen = picture.at(x, 0);
            if (std::abs(out - 1) < 2e-3) continue;  // the root is too inexact near 0
            if (out > 1) {
                EXPECT_EQ(seen, (std::array<float, 3>{})) << ratio << " " << x;
                ++total;
                continue;
            }
            EXPECT_NEAR(static_cast<double>(seen[0]), out, 2e-5) << ratio << " " << x;
            EXPECT_NEAR(static_cast<double>(seen[1]), -std::sqrt(1 - out * out), 2e-5) << ratio << " " << x;
        }
        EXPECT_GT(total, 60) << ratio;
    }
}

TEST(BezierCurves, AreTheSameBeforeAndAfterTheProjection) {
    // Both ways give the same homogeneous point. The difference is measured relative to w.
    const Files files{
        {"v.vert", "#version 330 core\nvoid main() { gl_Position = vec4(sign(aVertex.xy), 0., 1.); }\n"},
        {"f.frag",
         "#version 330 core\nout vec4 fColor;\n"
         "vec4 bezier(vec4 a, vec4 b, vec4 c, vec4 d, float t) {\n"
         "  float s = 1. - t;\n"
         "  return s*s*s*a + 3.*s*s*t*b + 3.*s*t*t*c + t*t*t*d;\n}\n"
         "void main() {\n  float t = gl_FragCoord.x / 256.;\n"
         "  vec4 p[4] = vec4[](vec4(-1., -.5, .2, 1.), vec4(-.2, 1.3, -.4, 1.),\n"
         "                     vec4(.7, -1.1, .6, 1.), vec4(1.2, .4, -.3, 1.));\n"
         "  mat4 m = uModelViewProjectionMatrix;\n"
         "  vec4 before = m * bezier(p[0], p[1], p[2], p[3], t);\n"
         "  vec4 after = bezier(m * p[0], m * p[1], m * p[2], m * p[3], t);\n"
         "  vec4 apart = abs(before - after) / after.w;\n"
         "  fColor = vec4(max(apart.x, apart.y), apart.w, after.w, 1.);\n}\n"}};
    const FloatPicture picture =
        draw("WindowSize 256 4\nPerspective 70 .1 100\n" + kFrontView +
                 "Rotate 25 1 2 3\nTranslate .3 -.2 .5\n" + kProgram + "QuadXY 0 1 1 1\n",
             files);
    ASSERT_EQ(picture.width, 256);
    EXPECT_EQ(picture.nonFinite(), 0U);
    double largest = 0;
    for (int x = 0; x < 256; ++x) {
        const auto seen = picture.at(x, 1);
        EXPECT_LT(seen[0], 1e-6F) << x;
        EXPECT_LT(seen[1], 1e-6F) << x;
        EXPECT_GT(seen[2], 1) << "the curve is in front of the eye";
        largest = std::max(largest, static_cast<double>(seen[0]));
    }
    EXPECT_GT(largest, 0) << "two orders of floating-point operations";
}

}  // namespace
}  // namespace glibra::stress
