// The output of the library's geometry and tessellation stages: vertices per level (NM12), curved PN
// triangles (NM34), triangles of equal size on balls of any size (NM42), and levels while the eye flies
// through a ball (exercises' accuracy table 24).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <numbers>

#include "support.h"

namespace glibra::stress {
namespace {

/// The number of points that a geometry stage of the library emits for one triangle. Each adds 1 to a pixel.
FloatPicture emittedPoints(const std::string& name, const std::string& output, int maxVertices, int level) {
    const std::string path = "geometry/" + name;
    std::string source = replaced(shipped(path + ".geom"), "layout(" + output + ") out",
                                  fmt::format("layout(points, max_vertices = {}) out", maxVertices));
    source = replaced(source, "clamp(uLevel, 0, 3)", "uLevel");
    return draw(
        fmt::format("WindowSize 32 32\nBackground 0\nOrtho -3 3 -3 3\nLookAt 0 0 5 0 0 0 0 1 0\n"
                    "Vertex v.vert\nGeometry g.geom\nFragment f.frag\n"
                    "Program P uLevel {} uRadius 1 uT .1 uVelScale 1 uGravity -1\n"
                    "glBegin triangles\nglVertex 1 0 0\nglVertex 0 1 0\nglVertex 0 0 1\nglEnd\n",
                    level),
        {{"v.vert", shipped(path + ".vert")}, {"g.geom", source}, {"f.frag", addingFragment("1., 0., 0.")}});
}

void expectVertices(const std::string& name, const std::string& output, int components,
                    const std::vector<int>& counts) {
    const gpu::Capabilities& driver = context().capabilities();
    const int most =
        std::min(driver.maxGeometryOutputVertices, driver.maxGeometryTotalOutputComponents / components);
    for (std::size_t level = 0; level < counts.size(); ++level) {
        const int count = counts[level];
        const FloatPicture picture = emittedPoints(name, output, count, static_cast<int>(level));
        EXPECT_EQ(has(picture.diagnostics, "glsl-W07"), count > most)
            << name << " " << level << text(picture.diagnostics);
        if (count <= most)
            EXPECT_EQ(picture.sum(0), count) << name << " " << level;
        else
            EXPECT_LE(picture.sum(0), most) << name << " " << level;
    }
}

TEST(SubdivisionLevels, EmitAsManyVerticesAsTheirStripsHave) {
    // One row of 2 c + 1 vertices for each c from 2^level down to 1.
    expectVertices("sphere_subdivision", "triangle_strip, max_vertices = 80", 7, {3, 8, 24, 80, 288, 1088});
}

TEST(SubdivisionLevels, EmitAsManyPointsAsTheirTriangleHas) {
    // (n + 1)(n + 2) / 2 points for n = 2^level.
    expectVertices("explosion", "points, max_vertices = 45", 7, {3, 6, 15, 45, 153, 561, 2145});
}

using Corner = std::array<double, 6>;  // position, normal

struct PnPoint {
    glm::dvec3 tess{0}, place{0};
};

/// The points of the library's PN triangle at level 8. Their parameters select the pixel.
std::map<int, PnPoint> pnTriangle(const std::array<Corner, 3>& corners) {
    const std::string control = shipped("tessellation/pn_triangles.tcs");
    std::string evaluation =
        replaced(shipped("tessellation/pn_triangles.tes"), "void main()", "void curve()");
    evaluation = replaced(evaluation, "equal_spacing, ccw)", "equal_spacing, ccw, point_mode)");
    evaluation +=
        "uniform bool uTess;\nout vec3 tePlace;\nvoid main() {\n  curve();\n"
        "  tePlace = uTess ? gl_TessCoord : gl_Position.xyz;\n"
        "  gl_Position = vec4((floor(63. * gl_TessCoord.xy) + .5) / 32. - 1., 0., 1.);\n}\n";
    std::string positions, normals;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& c = corners[i];
        const char* comma = i == 0 ? "" : ", ";
        positions += fmt::format("{}vec3({}, {}, {})", comma, c[0], c[1], c[2]);
        normals += fmt::format("{}vec3({}, {}, {})", comma, c[3], c[4], c[5]);
    }
    const Files files{
        {"v.vert",
         fmt::format("#version 400 core\nout vec3 vNormal;\nout vec4 vColor;\nvoid main() {{\n"
                     "  const vec3 p[3] = vec3[]({}), n[3] = vec3[]({});\n  int i = int(aVertex.x);\n"
                     "  vNormal = n[i];\n  vColor = vec4(1.);\n  gl_Position = vec4(p[i], 1.);\n}}\n",
                     positions, normals)},
        {"c.tesc", control},
        {"e.tese", evaluation},
        {"f.frag",
         "#version 400 core\nin vec3 tePlace;\nout vec4 fColor;\nvoid main() { fColor = vec4(tePlace, 1.); "
         "}\n"}};
    const auto drawn = [&](bool tess) {
        // -9 marks empty pixels.
        return draw(fmt::format("WindowSize 64 64\nBackground -9 -9 -9\nVertex v.vert\nTessControl "
                                "c.tesc\nTessEvaluation e.tese\nFragment f.frag\n"
                                "Program P uOuter 8 uInner 8 uScale 1 uTess {}\nNumPatchVertices 3\n"
                                "glBegin patches\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 2 0 0\nglEnd\n",
                                tess ? 1 : 0),
                    files);
    };
    const FloatPicture places = drawn(false);
    const FloatPicture tess = drawn(true);
    std::map<int, PnPoint> points;
    if (places.width != 64 || tess.width != 64) return points;
    for (int i = 0; i < 64 * 64; ++i) {
        const auto t = tess.at(i % 64, i / 64);
        const auto p = places.at(i % 64, i / 64);
        if (t[0] >= 0) points[i] = {glm::dvec3(t[0], t[1], t[2]), glm::dvec3(p[0], p[1], p[2])};
    }
    return points;
}

TEST(PnTriangles, PassThroughTheirCornersBitForBit) {
    const std::array<Corner, 3> corners{
        {{.3F, -1.7F, .9F, 0, .6, .8}, {2.1F, .4F, -.5F, 1, 0, 0}, {-.8F, 1.1F, .7F, 0, 0, 1}}};
    std::size_t found = 0;
    for (const auto& [pixel, point] : pnTriangle(corners))
        for (std::size_t k = 0; k < 3; ++k) {
            if (point.tess[static_cast<int>(k)] != 1) continue;
            ++found;
            const Corner& c = corners[k];
            EXPECT_EQ(point.place, glm::dvec3(static_cast<float>(c[0]), static_cast<float>(c[1]),
                                              static_cast<float>(c[2])))
                << k;
        }
    EXPECT_EQ(found, 3U);
}

TEST(PnTriangles, WithOneNormalAreTheFlatTriangle) {
    const glm::dvec3 a(1, 0, .5), b(-.5, 1.5, 1), c(.25, -1, 2);
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const auto corner = [&](const glm::dvec3& p) { return Corner{p.x, p.y, p.z, n.x, n.y, n.z}; };
    const auto points = pnTriangle({corner(a), corner(b), corner(c)});
    // 3 n^2 / 4 + 3 n / 2 + 1 vertices at an even level n, each in its own pixel.
    EXPECT_EQ(points.size(), 3U * 8 * 8 / 4 + 3U * 8 / 2 + 1);
    for (const auto& [pixel, point] : points) {
        const glm::dvec3 flat = point.tess.x * a + point.tess.y * b + point.tess.z * c;
        EXPECT_LT(glm::length(point.place - flat), 1e-6);
    }
}

TEST(PnTriangles, OfAnOctantBulgeByTheClosedForm) {
    // Let a, b and c be unit vectors at right angles. The middle of the edge between a and b is 5 / 8 (a +
    // b), and the middle of the triangle is 4 / 9 (a + b + c).
    const auto points = pnTriangle({{{1, 0, 0, 1, 0, 0}, {0, 1, 0, 0, 1, 0}, {0, 0, 1, 0, 0, 1}}});
    std::size_t middles = 0;
    for (const auto& [pixel, point] : points) {
        EXPECT_GT(glm::length(point.place), std::sqrt(3.) * 4 / 9 - 1e-6) << "its middle is the lowest point";
        EXPECT_LE(glm::length(point.place), 1 + 1e-6);
        for (int k = 0; k < 3; ++k) {
            if (point.tess[k] != 0 || point.tess[(k + 1) % 3] != .5) continue;
            ++middles;
            glm::dvec3 expected(.625);
            expected[k] = 0;
            EXPECT_LT(glm::length(point.place - expected), 1e-6);
        }
    }
    EXPECT_EQ(middles, 3U);
}

struct Areas {
    double count = 0, sum = 0, least = 1e9, most = 0;
};

/// The triangles of the library's octant with uOuter = uInner = 14 times the radius.
Areas octantAreas(double radius, double level) {
    const FloatPicture picture = draw(
        fmt::format(
            "WindowSize 256 256\nBackground 0\nLookAt 0 0 0 0 0 -1 0 1 0\nVertex v.vert\nTessControl "
            "c.tesc\nTessEvaluation e.tese\nGeometry g.geom\nFragment f.frag\n"
            "Program P uRadius {0} uOuter0 {1} uOuter1 {1} uOuter2 {1} uInner {1}\nNumPatchVertices 3\n"
            "glBegin patches\nglVertex 0 0 1\nglVertex 1 0 0\nglVertex 0 1 0\nglEnd\n",
            radius, level),
        {{"v.vert", shipped("tessellation/octant.vert")},
         {"c.tesc", shipped("tessellation/octant.tcs")},
         {"e.tese", shipped("tessellation/octant.tes")},
         {"g.geom",
          "#version 400 core\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\n"
          "flat out float gArea;\nvoid main() {\n"
          "  vec3 a = gl_in[0].gl_Position.xyz, b = gl_in[1].gl_Position.xyz, c = gl_in[2].gl_Position.xyz;\n"
          "  gArea = .5 * length(cross(b - a, c - a));\n"
          "  vec3 centre = a + b + c;\n"
          "  vec2 pixel = floor(255. * centre.xy / (centre.x + centre.y + centre.z));\n"
          "  gl_Position = vec4((pixel + .5) / 128. - 1., 0., 1.);\n  EmitVertex();\n  EndPrimitive();\n}\n"},
         {"f.frag", addingFragment("gArea, 1., 0.", "flat in float gArea;\n")}});
    Areas areas;
    for (int i = 0; i < 256 * 256 && picture.width == 256; ++i) {
        const auto seen = picture.at(i % 256, i / 256);
        if (seen[1] == 0) continue;
        EXPECT_EQ(seen[1], 1.F) << "one triangle a pixel";
        const auto area = static_cast<double>(seen[0]);
        areas.count += 1;
        areas.sum += area;
        areas.least = std::min(areas.least, area);
        areas.most = std::max(areas.most, area);
    }
    return areas;
}

TEST(OctantTriangles, KeepTheirSizeWhateverTheRadius) {
    std::vector<Areas> all;
    for (const double radius : {1., 1.5, 2.}) {
        const Areas areas = octantAreas(radius, 14);
        const double n = 14 * radius;
        EXPECT_EQ(areas.count, std::floor(3 * n * n / 2)) << radius;
        const double exact = std::numbers::pi * radius * radius / 2;
        EXPECT_LT(areas.sum, exact);
        EXPECT_GT(areas.sum, exact * (1 - 2 / (n * n)))
            << "chords miss the sphere by the square of the level";
        all.push_back(areas);
    }
    for (const Areas& each : all) {
        EXPECT_NEAR(each.sum / each.count, all[0].sum / all[0].count, .01 * all[0].sum / all[0].count);
    }
    // An odd level has a triangle in the middle, where even levels have a vertex.
    EXPECT_NEAR(all[2].most, all[0].most, .1 * all[0].most);
    EXPECT_NEAR(all[2].least, all[0].least, .1 * all[0].least);
    // If levels do not grow with the radius, the size of the triangles grows with its square.
    const Areas fixed = octantAreas(2, 7);
    EXPECT_NEAR(fixed.sum / fixed.count, 4 * all[0].sum / all[0].count, .05 * fixed.sum / fixed.count);
}

TEST(AdaptiveLevels, StayInRangeWhileTheEyeFliesThroughTheBall) {
    constexpr int kPlaces = 121;
    constexpr double kRadius = .42, kDetail = 22, kFieldOfView = 50;
    std::string scene = fmt::format(
        "WindowSize {} 1\nBackground 0\nPerspective {} .1 100\nLookAt 0 0 0 0 0 -1 0 1 0\nVertex "
        "v.vert\nTessControl c.tesc\nTessEvaluation e.tese\nFragment f.frag\nProgram P uDetail {}\n"
        "NumPatchVertices 1\n",
        kPlaces, kFieldOfView, kDetail);
    // The ball's centre moves from 3 in front of the eye, through the eye, to 3 behind it.
    for (int i = 0; i < kPlaces; ++i)
        scene += fmt::format(
            "PushMatrix\nTranslate 0 0 {}\nglBegin patches\nglVertex 0 0 0 {}\nglEnd\nPopMatrix\n",
            number((i - 60) * .05), kRadius);
    const Files files{
        {"v.vert", shipped("tessellation/spheres.vert")},
        {"c.tesc", shipped("tessellation/adaptive_spheres.tcs")},
        {"e.tese",
         fmt::format("#version 400 compatibility\nlayout(quads, point_mode) in;\nout float teLevel;\n"
                     "void main() {{\n  float place = floor(gl_ModelViewMatrix[3].z * 20. + 60.5);\n"
                     "  teLevel = gl_TessLevelOuter[1];\n"
                     "  gl_Position = vec4((place + .5) / {} * 2. - 1., 0., 0., 1.);\n}}\n",
                     kPlaces)},
        {"f.frag",
         "#version 400 core\nin float teLevel;\nout vec4 fColor;\n"
         "void main() { fColor = vec4(teLevel, isnan(teLevel) ? 0. : 1., 0., 1.); }\n"}};
    const FloatPicture picture = draw(scene, files);
    ASSERT_EQ(picture.width, kPlaces);
    EXPECT_EQ(picture.nonFinite(), 0U);
    const double scale = 1 / std::tan(kFieldOfView / 2 * std::numbers::pi / 180);
    for (int i = 0; i < kPlaces; ++i) {
        const auto level = static_cast<double>(picture.at(i, 0)[0]);
        EXPECT_EQ(picture.at(i, 0)[1], 1.F) << i;
        EXPECT_GE(level, 3) << i;
        const double distance = -(i - 60) * .05;
        if (std::abs(distance) <= kRadius) continue;
        // The width and height of the box; its depth is not visible from the front. The window is 121 times
        // as wide as it is high.
        const double side = 2 * kRadius * scale / std::abs(distance);
        const double size = std::hypot(side / kPlaces, side);
        EXPECT_NEAR(level, std::max(kDetail * size, 3.), 1e-5 * level) << distance;
    }
}

}  // namespace
}  // namespace glibra::stress
