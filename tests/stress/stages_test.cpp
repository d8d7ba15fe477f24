// Geometry stages at the driver's vertex limit and one above it (NM12). A lowered limit is reported, and all
// vertices within the limit are drawn. Each emitted point adds 1 to a pixel.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace glibra::stress {
namespace {

/// A geometry stage that emits uCount points, each with a position and `floats` varying components.
Files emitting(int maxVertices, int floats) {
    std::string declarations;
    std::string writes;
    std::string reads = "0.";
    for (int i = 0; i < floats / 4; ++i) {
        declarations += fmt::format("out vec4 gValue{};\n", i);
        writes += fmt::format("    gValue{} = vec4({}., float(i), 1., 2.);\n", i, i);
        reads += fmt::format(" + gValue{}.x - {}.", i, i);
    }
    std::string inputs = declarations;
    for (std::size_t at = inputs.find("out "); at != std::string::npos; at = inputs.find("out ", at + 1))
        inputs.replace(at, 4, "in ");
    return {
        {"v.vert", "#version 330 core\nvoid main() { gl_Position = aVertex; }\n"},
        {"g.geom",
         fmt::format(
             "#version 330 core\nlayout(points) in;\nlayout(points, max_vertices = {}) out;\n"
             "uniform int uCount;\n{}void main() {{\n  for (int i = 0; i < uCount; ++i) {{\n{}"
             "    gl_Position = vec4((float(i % 64) + .5) / 32. - 1., (float(i / 64) + .5) / 32. - 1., 0., "
             "1.);\n    EmitVertex();\n    EndPrimitive();\n  }}\n}}\n",
             maxVertices, declarations, writes)},
        {"f.frag", addingFragment("1., " + reads + ", 0.", inputs)}};
}

FloatPicture emitted(int count, int maxVertices, int floats,
                     const std::string& shape = "glBegin points\nglVertex 0 0 0\nglEnd") {
    return draw(
        fmt::format("WindowSize 64 64\nBackground 0\nVertex v.vert\nGeometry g.geom\nFragment f.frag\n"
                    "Program P uCount {}\n{}\n",
                    count, shape),
        emitting(maxVertices, floats));
}

TEST(GeometryStage, EmitsAllVerticesUpToTheDriversLimit) {
    const gpu::Capabilities& driver = context().capabilities();
    for (const int floats : {0, 4, 16, 56}) {
        // The position counts as four components.
        const int most = std::min(driver.maxGeometryOutputVertices,
                                  driver.maxGeometryTotalOutputComponents / (floats + 4));
        for (const int maxVertices : {most - 1, most}) {
            const FloatPicture picture = emitted(maxVertices, maxVertices, floats);
            EXPECT_EQ(picture.sum(0), maxVertices) << floats;
            EXPECT_EQ(picture.count([](const auto& rgb) { return rgb[0] > 1; }), 0U) << floats;
            EXPECT_EQ(picture.sum(1), 0) << floats;
            EXPECT_FALSE(has(picture.diagnostics, "glsl-W07")) << text(picture.diagnostics);
        }
        for (const int maxVertices : {most + 1, 4 * most}) {
            const FloatPicture picture = emitted(most, maxVertices, floats);
            EXPECT_TRUE(has(picture.diagnostics, "glsl-W07")) << floats << " " << maxVertices;
            EXPECT_EQ(picture.sum(0), most) << floats;
        }
    }
}

TEST(GeometryStage, DropsWhatItEmitsBeyondItsLimit) {
    // GL does not define which vertices are lost. Vertices that were not emitted must hit no pixel and no
    // memory.
    const int most = context().capabilities().maxGeometryOutputVertices;
    for (const auto& [count, limit] :
         {std::pair(most + 1, most), std::pair(4000, most), std::pair(100, 10), std::pair(2, 1)}) {
        const FloatPicture picture = emitted(count, limit, 0);
        EXPECT_LE(picture.sum(0), limit) << count;
        EXPECT_EQ(picture.nonFinite(), 0U);
    }
    // Many primitives in one draw, each above its limit.
    const FloatPicture many = emitted(4000, 16, 16, "PointCloud 20 20 20");
    EXPECT_LE(many.sum(0), 16 * 8000);
    EXPECT_EQ(many.nonFinite(), 0U);
}

TEST(GeometryStage, EmitsFromEachOfManyPrimitives) {
    const int most = std::min(context().capabilities().maxGeometryOutputVertices,
                              context().capabilities().maxGeometryTotalOutputComponents / 4);
    EXPECT_EQ(emitted(most, most, 0, "PointCloud 10 10 10").sum(0), 1000. * most);
}

TEST(GeometryStage, WithoutALayoutGetsTheLargestLimit) {
    Files files = emitting(1, 0);
    std::string& source = files["g.geom"];
    source =
        "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nuniform int uCount;\nvoid main() {\n"
        "  for (int i = 0; i < uCount; ++i) {\n"
        "    gl_Position = vec4((float(i - i / 64 * 64) + .5) / 32. - 1., (float(i / 64) + .5) / 32. - 1., "
        "0., 1.);\n"
        "    EmitVertex();\n    EndPrimitive();\n  }\n}\n";
    const int most = std::min(context().capabilities().maxGeometryOutputVertices,
                              context().capabilities().maxGeometryTotalOutputComponents / 4);
    for (const auto& [command, expected] :
         {std::pair(std::string(), most), std::pair(std::string("GeometryVerticesOut 7\n"), 7),
          std::pair(std::string("GeometryVerticesOut 100000\n"), most)}) {
        const FloatPicture picture = draw(
            fmt::format("WindowSize 64 64\nBackground 0\nVertex v.vert\nGeometry g.geom\nFragment f.frag\n"
                        "GeometryInput points\nGeometryOutput points\n{}Program P uCount {}\n"
                        "glBegin points\nglVertex 0 0 0\nglEnd\n",
                        command, expected),
            files);
        EXPECT_EQ(picture.sum(0), expected) << command;
    }
}

}  // namespace
}  // namespace glibra::stress
