// Vertices at infinity and behind the eye (exercises' accuracy table 24; NM05). GL must clip them. The
// reference is a second rasteriser, which never clips: it computes each pixel's position on the triangle in
// homogeneous coordinates (Olano and Greer 1997).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/view.h"
#include "support.h"

namespace glibra::stress {
namespace {

using ClipTriangle = std::array<glm::dvec4, 3>;

/// The number of triangles that certainly cover a pixel, and the number that may cover it. A triangle may
/// cover a pixel if the centre lies within 1/20 pixel of an edge or of the cut by the near or far plane.
struct Coverage {
    int least = 0, most = 0;
};

/// The distance in pixels from a point to the zero of a linear function with this value and slope there.
double inPixels(double value, const glm::dvec3& slope, double pixel) {
    return value / (std::hypot(slope.x, slope.y) * pixel);
}

std::vector<Coverage> coverage(const std::vector<ClipTriangle>& triangles, int size) {
    constexpr double kUnsure = .05;
    std::vector<Coverage> pixels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const double pixel = 2. / size;
    for (const ClipTriangle& t : triangles) {
        // lambda = inverse(x y w) * (px, py, 1) is the visible point of the triangle's plane, with w = 1.
        const glm::dmat3 corners(t[0].x, t[0].y, t[0].w, t[1].x, t[1].y, t[1].w, t[2].x, t[2].y, t[2].w);
        if (std::abs(glm::determinant(corners)) < 1e-9) continue;
        const glm::dmat3 rows = glm::transpose(glm::inverse(corners));
        const glm::dvec3 depth = rows[0] * t[0].z + rows[1] * t[1].z + rows[2] * t[2].z;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 p(pixel * (x + .5) - 1, 1 - pixel * (y + .5), 1);
                double inside = 1e9;  // distance in pixels to the nearest border, negative outside
                for (int i = 0; i < 3; ++i)
                    inside = std::min(inside, inPixels(glm::dot(rows[i], p), rows[i], pixel));
                const double z = glm::dot(depth, p);
                if (std::hypot(depth.x, depth.y) > 1e-12)
                    inside = std::min({inside, inPixels(1 - z, depth, pixel), inPixels(1 + z, depth, pixel)});
                else if (std::abs(z) > 1)
                    inside = -1e9;
                Coverage& at = pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                                      static_cast<std::size_t>(x)];
                at.least += inside > kUnsure ? 1 : 0;
                at.most += inside > -kUnsure ? 1 : 0;
            }
    }
    return pixels;
}

/// The picture's red counts coverage; every pixel must lie between the reference's bounds.
void expectCoverage(const FloatPicture& picture, const std::vector<ClipTriangle>& triangles,
                    const std::string& what) {
    ASSERT_EQ(picture.width, picture.height) << what;
    EXPECT_EQ(picture.nonFinite(), 0U) << what;
    const std::vector<Coverage> expected = coverage(triangles, picture.width);
    std::size_t wrong = 0;
    std::size_t sure = 0;
    std::string first;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Coverage& at =
                expected[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(x)];
            const double seen = static_cast<double>(picture.at(x, y)[0]);
            sure += at.least == at.most ? 1 : 0;
            if (seen >= at.least && seen <= at.most) continue;
            if (wrong++ == 0)
                first = fmt::format("pixel {}, {}: {} times, not {} to {}", x, y, seen, at.least, at.most);
        }
    EXPECT_EQ(wrong, 0U) << what << ": " << first;
    // A reference that is uncertain everywhere would prove nothing.
    EXPECT_GT(sure, expected.size() * 6 / 10) << what;
}

std::string vertexLine(const glm::dvec4& v) {
    return fmt::format("glVertex {} {} {} {}\n", v.x, v.y, v.z, v.w);
}

/// Numbers that floats represent exactly, so that scene and reference use the same values.
double asFloat(double value) {
    return static_cast<double>(static_cast<float>(value));
}

std::string listOf(const std::vector<ClipTriangle>& triangles) {
    std::string text = "glBegin triangles\n";
    for (const ClipTriangle& each : triangles)
        for (const glm::dvec4& corner : each) text += vertexLine(corner);
    return text + "glEnd\n";
}

/// A vertex stage that copies positions to clip coordinates.
const Files kAsTheyAre{{"v.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n"},
                       {"f.frag", addingFragment("1., 0., 0.")}};
const Files kByMatrix{
    {"v.vert", "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n"},
    {"f.frag", addingFragment("1., 0., 0.")}};
const std::string kWindow = "WindowSize 64 64\nBackground 0\n";

TEST(HomogeneousVertices, WithWeightZeroAreDirections) {
    const ClipTriangle quadrant{glm::dvec4(0, 0, 0, 1), glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0)};
    const FloatPicture picture = draw(kWindow + kProgram + listOf({quadrant}), kAsTheyAre);
    ASSERT_EQ(picture.width, 64);
    // Exactly the pixels to the right of and above the centre.
    std::size_t wrong = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) wrong += picture.at(x, y)[0] == (x >= 32 && y < 32 ? 1.F : 0.F) ? 0 : 1;
    EXPECT_EQ(wrong, 0U);
}

TEST(HomogeneousVertices, WithNegativeWeightAreBehindTheEye) {
    // If all three weights are negative, nothing is visible, although the points of projective space are the
    // same. If one or two are, the part in front of the eye is visible.
    const ClipTriangle behind{glm::dvec4(-.5, -.5, 0, -1), glm::dvec4(.5, -.5, 0, -1),
                              glm::dvec4(0, .5, 0, -1)};
    EXPECT_EQ(draw(kWindow + kProgram + listOf({behind}), kAsTheyAre).sum(0), 0);
    for (std::uint32_t i = 0; i < 30; ++i) {
        std::vector<ClipTriangle> triangles(1);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double w = k == 0 || (k == 1 && i % 2 == 0) ? -.5 - std::abs(spread(50 * i + k))
                                                              : .5 + std::abs(spread(50 * i + k));
            triangles[0][k] = {asFloat(2 * spread(50 * i + k + 10)), asFloat(2 * spread(50 * i + k + 20)), 0,
                               asFloat(w)};
        }
        expectCoverage(draw(kWindow + kProgram + listOf(triangles), kAsTheyAre), triangles,
                       listOf(triangles));
    }
}

TEST(HomogeneousVertices, WithAnyWeightCoverThePixelsOfProjectiveGeometry) {
    // Each picture has several triangles, with positive, negative and zero weights, and depths that the near
    // and far planes cut.
    for (std::uint32_t i = 0; i < 60; ++i) {
        std::vector<ClipTriangle> triangles(6);
        std::uint32_t n = 1000 * i;
        const auto next = [&](double size) { return asFloat(size * spread(n++)); };
        for (ClipTriangle& each : triangles)
            for (glm::dvec4& corner : each) {
                corner.w = next(1) < -.6 ? 0 : next(1.5);
                corner.x = next(2);
                corner.y = next(2);
                corner.z = next(1.5);
            }
        expectCoverage(draw(kWindow + kProgram + listOf(triangles), kAsTheyAre), triangles,
                       fmt::format("set {}", i));
    }
}

TEST(HomogeneousVertices, ReachTheShaderUntouched) {
    const FloatPicture picture = draw(kWindow + kProgram + "glBegin points\nglVertex 3 -2 .5 -4\nglEnd\n",
                                      {{"v.vert",
                                        "#version 330 core\nout vec4 vRaw;\nvoid main() { vRaw = aVertex; "
                                        "gl_Position = vec4(0., 0., 0., 1.); }\n"},
                                       {"f.frag",
                                        "#version 330 core\nin vec4 vRaw;\nout vec4 fColor;\nvoid main() { "
                                        "fColor = vec4(vRaw.xzw, 1.); }\n"}});
    EXPECT_EQ(picture.sum(0), 3);
    EXPECT_EQ(picture.sum(1), .5);
    EXPECT_EQ(picture.sum(2), -4);
}

/// The difference b - a of two homogeneous points, computed by a vertex stage. The vertex is the first point,
/// a uniform the second.
std::array<float, 3> difference(const glm::dvec4& a, const glm::dvec4& b) {
    const FloatPicture picture =
        draw(fmt::format("WindowSize 1 1\n{}Program P uTo [{} {} {} {}]\nglBegin points\n{}glEnd\n",
                         "Vertex v.vert\nFragment f.frag\n", b.x, b.y, b.z, b.w, vertexLine(a)),
             {{"v.vert",
               "#version 330 core\nuniform vec4 uTo;\nflat out vec3 vDifference;\nvoid main() {\n"
               "  vDifference = aVertex.w * uTo.xyz - uTo.w * aVertex.xyz;\n"
               "  gl_Position = vec4(0., 0., 0., 1.);\n}\n"},
              {"f.frag",
               "#version 330 core\nflat in vec3 vDifference;\nout vec4 fColor;\n"
               "void main() { fColor = vec4(vDifference, 1.); }\n"}});
    return picture.width == 1 ? picture.at(0, 0) : std::array<float, 3>{};
}

glm::dvec3 directionOf(const std::array<float, 3>& v) {
    return glm::normalize(
        glm::dvec3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])));
}

TEST(HomogeneousDifference, IsThatOfThePointsTimesTheirWeights) {
    // Multiples of 1/4 and 1/8, so that all products are exact.
    EXPECT_EQ(difference({.5, -2, 3, 2}, {4, 1.25, -.75, 4}), (std::array<float, 3>{6, 10.5, -13.5}));
    for (const double weight : {.125, 1., 64.}) {
        const glm::dvec3 direction =
            directionOf(difference({.25, .5, -1, 1}, weight * glm::dvec4(3, -2, 5, 1)));
        EXPECT_LT(glm::length(direction - glm::normalize(glm::dvec3(2.75, -2.5, 6))), 1e-6) << weight;
    }
}

TEST(HomogeneousDifference, ToADirectionIsThatDirectionFromEveryPoint) {
    const glm::dvec3 sun(3, 4, -12);
    for (const glm::dvec4& from :
         {glm::dvec4(0, 0, 0, 1), glm::dvec4(1e6, -1e6, 5, 1), glm::dvec4(1, 2, 3, 8)}) {
        const std::array<float, 3> seen = difference(from, glm::dvec4(sun, 0));
        const auto w = static_cast<float>(from.w);
        EXPECT_EQ(seen, (std::array<float, 3>{3 * w, 4 * w, -12 * w}));
        // The difference to a point tends to this as the point moves away; 13 is the length of the direction.
        double before = 4;
        for (double weight = 1e-2; weight >= 1e-7; weight /= 10) {
            const double off =
                glm::length(directionOf(difference(from, glm::dvec4(sun, weight))) - sun / 13.);
            EXPECT_LE(off, before + 2e-7);
            before = off;
        }
        EXPECT_LT(before, 1.1e6 * 1.5e-7 / 13 + 1e-6);
    }
    // Two directions have no difference; the result must not be NaN.
    EXPECT_EQ(difference({1, 2, 3, 0}, {4, 5, 6, 0}), (std::array<float, 3>{0, 0, 0}));
}

TEST(HomogeneousVertices, HaveFiniteFrames) {
    for (const char* text :
         {"Triangles [0 0 0 1] [1 0 0 0] [0 1 0 0]", "Triangles [1 0 0 0] [0 1 0 0] [0 0 1 0]",
          "Triangles [0 0 0 -1] [1 0 0 -1] [0 1 0 -2]", "Triangles [0 0 0 0] [0 0 0 0] [0 0 0 0]",
          "Triangles [0 0 0 1e-38] [1 0 0 1e-38] [0 1 0 1e-38]"}) {
        const geometry::Mesh mesh = meshOf(text);
        for (const geometry::Attribute& each : mesh.attributes)
            for (const float value : each.values)
                EXPECT_TRUE(std::isfinite(value)) << text << " " << each.name;
        const geometry::Attribute* normals = mesh.attribute(geometry::kNormal);
        ASSERT_NE(normals, nullptr);
        for (std::size_t i = 0; i < 3; ++i) {
            const float* n = normals->values.data() + 3 * i;
            EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-6) << text;
        }
    }
}

/// The clip coordinates of the triangles of a scene's only draw.
std::vector<ClipTriangle> clipTriangles(const std::string& text) {
    const scene::Scene scene = interpreted(text);
    const geometry::Mesh mesh = meshOf(text);
    const scene::Draw& draw = std::get<scene::Draw>(scene.frame.passes.at(0).steps.at(0));
    const glm::dmat4 matrix = scene::projectionMatrix(*draw.projection, 1) * draw.modelView;
    const geometry::Attribute& positions = *mesh.attribute(geometry::kPosition);
    std::vector<ClipTriangle> triangles;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        ClipTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const float* p = positions.values.data() +
                             mesh.indices[i + k] * static_cast<std::size_t>(positions.components);
            triangle[k] = matrix * glm::dvec4(static_cast<double>(p[0]), static_cast<double>(p[1]),
                                              static_cast<double>(p[2]), 1);
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

TEST(GeometryThroughTheEye, IsCutAsProjectiveGeometrySays) {
    // Large triangles around the eye. Many pass close to it, and some pass behind it.
    for (std::uint32_t i = 0; i < 40; ++i) {
        std::string list = "Triangles";
        std::uint32_t n = 100'000 + 100 * i;
        for (int corner = 0; corner < 12; ++corner) {
            const double x = spread(n++);
            const double y = spread(n++);
            list += fmt::format(" [{} {} {}]", asFloat(5 * x), asFloat(5 * y), asFloat(5 * spread(n++)));
        }
        const std::string text = fmt::format("{}Perspective 80 .1 100\n{}{}\n", kWindow, kProgram, list);
        expectCoverage(draw(text, kByMatrix), clipTriangles(text), list);
    }
}

TEST(GeometryThroughTheEye, SurroundingItCoversEveryPixelOnce) {
    for (const char* shape : {"Sphere 3 24 12", "Box 4 4 4", "Translate .3 -1 .2\nCylinder 3 2 24 4",
                              "Soccerball .2", "Sphere 1000 24 12", "Scale -2 1 1\nSphere 1.5 24 12"}) {
        const std::string text =
            kWindow + "Perspective 100 .01 5000\nRotate 33 1 2 3\n" + kProgram + shape + "\n";
        const FloatPicture picture = draw(text, kByMatrix);
        EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] == 1; }), 64U * 64) << shape;
    }
}

TEST(GeometryThroughTheEye, IsCutOpenByANearPlaneInsideIt) {
    for (const double distance : {.5, 1., 1.3, 1.9, 2.6, 2.95, 3.2})
        for (const char* shape : {"Sphere 1 24 12", "Torus 1 .4 10 20", "Rotate 20 1 1 1\nBox 1.5 1.5 1.5",
                                  "Rotate 40 0 1 1\nCone 1 1.5 20 4"}) {
            const std::string text = kWindow + "Perspective 60 1.9 10\nTranslate 0 0 " + number(-distance) +
                                     "\n" + kProgram + shape + "\n";
            expectCoverage(draw(text, kByMatrix), clipTriangles(text), text);
        }
}

TEST(GeometryThroughTheEye, OfAFarPlaneThatIsHugelyFartherIsStillCut) {
    const std::string text = kWindow + "Perspective 60 1e-4 1e7\nRotate 15 1 2 0\nTranslate 0 0 -1.00005\n" +
                             kProgram + "Sphere 1 24 12\n";
    expectCoverage(draw(text, kByMatrix), clipTriangles(text), text);
}

}  // namespace
}  // namespace glibra::stress
