// gl_PrimitiveID and gl_PrimitiveIDIn of large draws. Each patch or triangle colours the pixel with its
// number, and every pixel must be coloured once.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.h"

namespace glibra::stress {
namespace {

constexpr int kNumbersSide = 256;

std::string start(const std::string& stages) {
    return fmt::format(
        "WindowSize {0} {0}\nBackground 0\nOrtho -1 1 -1 1 -1 1\nVertex v.vert\n{1}Fragment "
        "f.frag\n",
        kNumbersSide, stages);
}

const char* const kVertex = "#version 400 core\nvoid main() { gl_Position = aVertex; }\n";

/// The GLSL statement that sets gl_Position to the middle of pixel `number`.
std::string toPixel(const std::string& number) {
    return fmt::format("gl_Position = vec4((vec2({0} % {1}, {0} / {1}) + .5) / {2}. - 1., 0., 1.)", number,
                       kNumbersSide, kNumbersSide / 2);
}

/// Expects that pixels 0 .. count - 1, in rows from the lower left, have the value and all others 0.
void expectEachOnce(const FloatPicture& picture, int count, float value = 1) {
    int wrong = 0, first = -1;
    for (int i = 0; i < kNumbersSide * kNumbersSide; ++i) {
        const float expected = i < count ? value : 0.F;
        if (picture.at(i % kNumbersSide, kNumbersSide - 1 - i / kNumbersSide)[0] == expected) continue;
        if (wrong++ == 0) first = i;
    }
    EXPECT_EQ(wrong, 0) << "the first is number " << first;
}

std::string patches(int count, int vertices) {
    std::string text = fmt::format("Program P uLevel 16.\nNumPatchVertices {}\nglBegin patches\n", vertices);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < vertices; ++j) text += fmt::format("glVertex {} 0 0\n", i);
    return text + "glEnd\n";
}

TEST(PatchNumbers, WithoutAControlStageAreThoseOfTheWholeDraw) {
    // The driver processes 1024 vertices at a time.
    for (const int vertices : {1, 3, 32})
        for (const int count : {32, 3000}) {
            SCOPED_TRACE(fmt::format("{} of {} vertices", count, vertices));
            const FloatPicture picture =
                draw(start("TessEvaluation e.tese\n") + patches(count, vertices),
                     {{"v.vert", kVertex},
                      {"e.tese", "#version 400 core\nlayout(isolines, point_mode) in;\nvoid main() { " +
                                     toPixel("gl_PrimitiveID") +
                                     "; if (gl_TessCoord.x > 0.) gl_Position = vec4(2., 2., 0., 1.); }\n"},
                      {"f.frag", addingFragment("1., 0., 0.")}});
            expectEachOnce(picture, count);
        }
}

const char* const kControl =
    "#version 400 core\nlayout(vertices = 1) out;\nuniform float uLevel;\nvoid main() {\n"
    "  gl_out[gl_InvocationID].gl_Position = gl_in[0].gl_Position;\n"
    "  for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uLevel;\n"
    "  gl_TessLevelInner[0] = gl_TessLevelInner[1] = uLevel;\n}\n";

TEST(PatchNumbers, InTheFragmentStageAreThoseOfTheWholeDraw) {
    // A patch of level 16 becomes 289 vertices. 3000 patches have 13 times as many vertices as 16 bits can
    // number.
    for (const std::string stages :
         {"TessEvaluation e.tese\n", "TessControl c.tesc\nTessEvaluation e.tese\n"}) {
        SCOPED_TRACE(stages);
        const FloatPicture picture =
            draw(start(stages) + patches(3000, 1),
                 {{"v.vert", kVertex},
                  {"c.tesc", kControl},
                  {"e.tese",
                   "#version 400 core\nlayout(quads) in;\nflat out float vOwn;\nvoid main() {\n  "
                   "int own = int(gl_in[0].gl_Position.x + .5);\n  vOwn = float(own);\n" +
                       toPixel("own") +
                       fmt::format(";\n  gl_Position.xy += (gl_TessCoord.xy - .45) / {}.;\n}}\n",
                                   kNumbersSide / 2)},
                  {"f.frag", addingFragment("vOwn == float(gl_PrimitiveID) ? 1. : 1000., 0., 0.",
                                            "flat in float vOwn;\n")}});
        expectEachOnce(picture, 3000);
    }
}

std::string geometry(const std::string& input) {
    return "#version 400 core\nlayout(" + input +
           ") in;\nlayout(points, max_vertices = 1) out;\nvoid main() { " + toPixel("gl_PrimitiveIDIn") +
           "; EmitVertex(); }\n";
}

const char* const kEvaluation =
    "#version 400 core\nlayout(quads) in;\nvoid main() { gl_Position = gl_in[0].gl_Position; }\n";

TEST(PatchNumbers, InTheGeometryStageAreThoseOfTheWholeDraw) {
    // Patches of 512 triangles. Some drivers number the triangles there.
    for (const int count : {120, 3000}) {
        const FloatPicture picture =
            draw(start("TessControl c.tesc\nTessEvaluation e.tese\nGeometry g.geom\n") + patches(count, 1),
                 {{"v.vert", kVertex},
                  {"c.tesc", kControl},
                  {"e.tese", kEvaluation},
                  {"g.geom", geometry("triangles")},
                  {"f.frag", addingFragment("1., 0., 0.")}});
        expectEachOnce(picture, count, 512);
    }
}

TEST(PrimitiveNumbers, PassThroughAGeometryStageThatWritesNone) {
    // The fragment stage compares with the number that the geometry stage passes on itself.
    const std::string stage = geometry("triangles");
    const std::string passing = replaced(replaced(stage, "void main() {",
                                                  "flat out float gOwn;\nvoid main() { gOwn = "
                                                  "float(gl_PrimitiveIDIn);"),
                                         "max_vertices = 1", "max_vertices = 2");
    const std::string twice = replaced(
        passing, "EmitVertex();",
        "EmitVertex(); gOwn = float(gl_PrimitiveIDIn); " + toPixel("gl_PrimitiveIDIn") + "; EmitVertex();");
    const std::string fragment =
        addingFragment("gOwn == float(gl_PrimitiveID) ? 1. : 1000., 0., 0.", "flat in float gOwn;\n");
    const FloatPicture mesh = draw(start("Geometry g.geom\n") + "Program P\nSphere 1 20 15\n",
                                   {{"v.vert", kVertex}, {"g.geom", twice}, {"f.frag", fragment}});
    expectEachOnce(mesh, 2 * 14 * 20, 2);
    const FloatPicture tessellated =
        draw(start("TessControl c.tesc\nTessEvaluation e.tese\nGeometry g.geom\n") + patches(50, 1),
             {{"v.vert", kVertex},
              {"c.tesc", kControl},
              {"e.tese", kEvaluation},
              {"g.geom", twice},
              {"f.frag", fragment}});
    expectEachOnce(tessellated, 50, 1024);
}

TEST(TriangleNumbers, OfAMeshAreThoseOfTheWholeDraw) {
    // 2 * 149 * 200 triangles that share vertices.
    const FloatPicture picture = draw(
        start("Geometry g.geom\n") + "Program P\nSphere 1 200 150\n",
        {{"v.vert", kVertex}, {"g.geom", geometry("triangles")}, {"f.frag", addingFragment("1., 0., 0.")}});
    expectEachOnce(picture, 2 * 149 * 200);
}

}  // namespace
}  // namespace glibra::stress
