// Frames at poles and degenerate faces (exercises' accuracy table 19, 20; NM16, NM48): every vertex of every
// shape has a unit normal and a unit tangent at right angles to it, at any subdivision and any size.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "geometry/obj/obj_model.h"
#include "support.h"

namespace glibra::stress {
namespace {

glm::dvec3 vectorAt(const geometry::Attribute& attribute, std::size_t vertex) {
    const float* v = attribute.values.data() + vertex * static_cast<std::size_t>(attribute.components);
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

struct FrameErrors {
    double normal = 0, tangent = 0, angle = 0;  ///< largest: | |n| - 1 |, | |t| - 1 |, |n . t|
    bool finite = true;
};

FrameErrors frameErrors(const geometry::Mesh& mesh) {
    FrameErrors errors;
    for (const geometry::Attribute& each : mesh.attributes)
        for (const float value : each.values) errors.finite = errors.finite && std::isfinite(value);
    const geometry::Attribute* normals = mesh.attribute(geometry::kNormal);
    const geometry::Attribute* tangents = mesh.attribute(geometry::kTangent);
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
        if (!normals) continue;
        const glm::dvec3 n = vectorAt(*normals, i);
        errors.normal = std::max(errors.normal, std::abs(glm::length(n) - 1));
        if (!tangents) continue;
        const glm::dvec3 t = vectorAt(*tangents, i);
        errors.tangent = std::max(errors.tangent, std::abs(glm::length(t) - 1));
        errors.angle = std::max(errors.angle, std::abs(glm::dot(n, t)));
    }
    return errors;
}

void expectFrames(const std::string& text, const geometry::Mesh& mesh) {
    ASSERT_GT(mesh.vertexCount(), 0U) << text;
    const FrameErrors errors = frameErrors(mesh);
    EXPECT_TRUE(errors.finite) << text;
    EXPECT_LT(errors.normal, 1.2e-7) << text;  // a unit vector rounded to float
    EXPECT_LT(errors.tangent, 1.2e-7) << text;
    EXPECT_LT(errors.angle, 1.2e-7) << text;
}

/// The number of triangles without area, computed in double from the positions that the device gets.
std::size_t withoutArea(const geometry::Mesh& mesh) {
    const geometry::Attribute& positions = *mesh.attribute(geometry::kPosition);
    std::size_t found = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = vectorAt(positions, mesh.indices[i]);
        const glm::dvec3 b = vectorAt(positions, mesh.indices[i + 1]);
        const glm::dvec3 c = vectorAt(positions, mesh.indices[i + 2]);
        found += glm::length(glm::cross(b - a, c - a)) > 0 ? 0 : 1;
    }
    return found;
}

TEST(ShapeFrames, AreUnitAndPerpendicularAtEverySubdivision) {
    std::vector<std::string> shapes{"Teapot",          "Soccerball 1",    "Box 1 2 3",      "WireTeapot",
                                    "WireCube 1",      "QuadXY -1 2 3 5", "QuadXZ 1 2 3 5", "QuadYZ -1 2 3 5",
                                    "QuadBox 7",       "Xarrow 2",        "Xarrow 3",       "Xarrow 101",
                                    "PointCloud 3 3 3"};
    for (const int n : {3, 4, 5, 7, 24, 48, 181, 360, 500})
        for (const int m : {2, 3, 7, 90})
            for (const char* shape : {"Sphere 1", "Cylinder 1 2", "Cone 1 2", "Torus 1 .5", "DiskXY 0 1",
                                      "WireSphere 1", "WireCone 1 2", "WireCylinder 1 2"})
                shapes.push_back(std::string(shape) + " " + std::to_string(n) + " " +
                                 std::to_string(std::string_view(shape).starts_with("Torus") ? m + 1 : m));
    for (const std::string& each : shapes) {
        const geometry::Mesh mesh = meshOf(each);
        expectFrames(each, mesh);
        if (mesh.topology == geometry::Topology::triangles) {
            EXPECT_EQ(withoutArea(mesh), 0U) << each;
        }
    }
}

TEST(ShapeFrames, DoNotDependOnTheSize) {
    // From sizes whose squares underflow in float to sizes whose squares overflow.
    for (const char* size : {"1e-37", "1e-30", "1e-20", "1e20", "1e37"}) {
        for (const char* shape : {"Sphere {} 12 7", "Cylinder {0} {0} 12 3", "Cone {0} {0} 12 3",
                                  "Cone 1 {} 12 3", "Cone {} 1 12 3", "Torus {} 1 7 9", "Soccerball {}",
                                  "DiskXY 0 {} 12 3", "QuadXY 0 {}", "Box {} 1 1"}) {
            const std::string each = fmt::format(fmt::runtime(shape), size);
            expectFrames(each, meshOf(each));
        }
    }
}

TEST(ShapeFrames, LatitudesOfASphereAreExactWhateverTheSubdivision) {
    // Integer division of degrees would space rows unevenly unless the count divides 180.
    for (const int stacks : {7, 24, 48, 500}) {
        const geometry::Mesh mesh = meshOf("Sphere 1 5 " + std::to_string(stacks));
        const geometry::Attribute& positions = *mesh.attribute(geometry::kPosition);
        const geometry::Attribute& st = *mesh.attribute(geometry::kTexCoord);
        for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
            const double row = std::round(
                static_cast<double>(st.values[i * static_cast<std::size_t>(st.components) + 1]) * stacks);
            const auto y = static_cast<double>(-std::cos(std::numbers::pi_v<long double> * row / stacks));
            EXPECT_NEAR(vectorAt(positions, i).y, y, 6e-8) << stacks;
        }
    }
}

TEST(TeapotFrames, AtTheDegeneratePatchesAreTheLimits) {
    const geometry::Mesh mesh = meshOf("Teapot");
    const geometry::Attribute& positions = *mesh.attribute(geometry::kPosition);
    const geometry::Attribute& normals = *mesh.attribute(geometry::kNormal);
    const geometry::Attribute& tangents = *mesh.attribute(geometry::kTangent);
    // At a pole a whole row of a patch is a single point on the axis. Four patches with 17 vertices each meet
    // there.
    int bottom = 0;
    int knob = 0;
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = vectorAt(positions, i);
        if (p.x != 0 || p.z != 0) continue;
        const glm::dvec3 n = vectorAt(normals, i);
        const bool isKnob = p.y > 0;
        (isKnob ? knob : bottom) += 1;
        EXPECT_EQ(n, glm::dvec3(0, isKnob ? 1 : -1, 0)) << i;
        EXPECT_EQ(vectorAt(tangents, i).y, 0) << i;
    }
    EXPECT_EQ(bottom, 4 * 17);
    EXPECT_EQ(knob, 4 * 17);
}

TEST(DegenerateTriangles, OfAListHaveNormalsAndDrawNothing) {
    const std::vector<std::string> lists{
        "Triangles [0 0 0] [0 0 0] [0 0 0]",          // a point
        "Triangles [0 0 0] [1 0 0] [2 0 0]",          // a line
        "Triangles [0 0 0] [1 1 1] [0 0 0]",          // a line there and back
        "Triangles [0 0 0] [1e-30 0 0] [0 1e-30 0]",  // an area that vanishes in float
        "Triangles [1e30 0 0] [1e30 1 0] [1e30 0 1]",
        "Triangles [.1 .1 .1] [.2 .2 .2] [.7 .7 .7]",  // collinear except for rounding
        "glBegin triangle_strip\nglVertex 0 0 0\nglVertex 0 0 0\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd",
        "glBegin quads\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 1 0 0\nglVertex 0 0 0\nglEnd",
        "glBegin polygon\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 2 0 0\nglVertex 3 0 0\nglEnd"};
    for (const std::string& each : lists) {
        expectFrames(each, meshOf(each));
        const FloatPicture picture =
            draw("WindowSize 32 32\nBackground 0\nOrtho -1 1 -1 1\nLookAt 0 0 5 0 0 0 0 1 0\n" +
                     std::string(kProgram) + each + "\n",
                 shaded("vec3(1.) + normalize(vN)"));
        EXPECT_EQ(picture.nonFinite(), 0U) << each;
        EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] != 0; }), 0U) << each;
    }
}

TEST(DegenerateTriangles, OfAModelHaveFrames) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nv 1e30 0 0\nv 0 1e30 0\nvt 0 0\nvt 0 "
        "0\nvt 1 1\n"
        "vn 0 0 0\nvn 1e-30 0 0\nvn 1e30 1e30 0\n"
        "f 1 2 3\nf 1 1 1\nf 1 2 4\nf 1 2 2\nf 1/1 2/2 3/1\nf 1/1 2/3 4/1\nf 1//1 2//1 3//1\nf 1//2 2//2 "
        "3//3\n"
        "f 1 5 6\nf 1 7 8\nf 1/3 2/3 3/3\n";
    const Result<geometry::ObjModel> model = geometry::parseObj(text, "degenerate.obj");
    ASSERT_TRUE(model);
    expectFrames("obj", geometry::obj(*model));
    expectFrames("objAdj", geometry::objAdj(*model));
    expectFrames("objPatch", geometry::objPatch(*model));
    expectFrames("wireObj", geometry::wireObj(*model));
    EXPECT_EQ(geometry::obj(*model).indices.size(), 33U);
}

TEST(DegenerateTriangles, ThatAGeometryStageShrinksToPointsCoverNothing) {
    // With shrink factor 0 every triangle becomes its centroid; with 1 the surface is whole.
    const std::string geometry =
        "#version 330 core\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n"
        "uniform float uShrink;\nvoid main() {\n"
        "  vec4 centre = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;\n"
        "  for (int i = 0; i < 3; ++i) {\n"
        "    gl_Position = uModelViewProjectionMatrix * (uShrink == 1. ? gl_in[i].gl_Position\n"
        "                  : centre + uShrink * (gl_in[i].gl_Position - centre));\n    EmitVertex();\n  "
        "}\n}\n";
    const Files files{{"v.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n"},
                      {"g.geom", geometry},
                      {"f.frag", addingFragment("1., 0., 0.")}};
    const auto covered = [&](const std::string& factor) {
        const FloatPicture picture = draw(
            "WindowSize 200 200\nBackground 0\nOrtho -1.5 1.5 -1.5 1.5\nLookAt 0 0 5 0 0 0 0 1 0\n"
            "Vertex v.vert\nGeometry g.geom\nFragment f.frag\nProgram P uShrink " +
                factor + "\nSphere 1 40 20\n",
            files);
        EXPECT_EQ(picture.nonFinite(), 0U);
        return picture.sum(0);
    };
    EXPECT_EQ(covered("0"), 0);
    const double whole = 2 * std::numbers::pi * std::pow(200 / 3., 2);  // front and back
    EXPECT_NEAR(covered("1"), whole, .01 * whole);
    EXPECT_NEAR(covered(".5"), whole / 4, .02 * whole);
}

}  // namespace
}  // namespace glibra::stress
