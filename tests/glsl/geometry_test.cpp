// Geometry and tessellation stages (language, 7.7 and 7.8).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::string kOld = "#version 120\n#extension GL_EXT_geometry_shader4 : enable\n";

std::string geometry(const std::string& body) {
    return userPart(translateSingle(Stage::geometry, kOld + body), Stage::geometry);
}

TEST(Geometry, PositionInIsAMemberOfTheInputs) {
    EXPECT_TRUE(hasTokens(
        geometry(
            "void main() { gl_Position = gl_PositionIn[(1 + 1) * int(vec2(1.)[0])].xyzw; EmitVertex(); }"),
        "gl_in[(1 + 1) * int(vec2(1.)[0])].gl_Position.xyzw"));
}

TEST(Geometry, OtherInputsAreMembersToo) {
    const std::string text = geometry(
        "void main() { gl_PointSize = gl_PointSizeIn[0]; gl_ClipDistance[0] = gl_ClipDistanceIn[1][0]; "
        "gl_PrimitiveID = gl_PrimitiveIDIn[0] + gl_PrimitiveIDIn; gl_Position = vec4(gl_VerticesIn, "
        "gl_PositionIn.length(), 0, 1); EmitVertex(); }");
    EXPECT_TRUE(hasTokens(text, "gl_in[0].gl_PointSize"));
    EXPECT_TRUE(hasTokens(text, "gl_in[1].gl_ClipDistance[0]"));
    EXPECT_TRUE(hasTokens(text, "gl_PrimitiveIDIn + gl_PrimitiveIDIn"));
    EXPECT_TRUE(hasTokens(text, "vec4(gl_in.length(), gl_in.length(), 0, 1)"));
}

TEST(Geometry, LayoutIsSynthesised) {
    ProgramRequest request =
        single(Stage::geometry, kOld + "void main() { gl_Position = gl_PositionIn[0]; EmitVertex(); }");
    const TranslatedProgram plain = translate(request);
    EXPECT_TRUE(hasTokens(sourceOf(plain, Stage::geometry), "layout(triangles) in;"));
    EXPECT_TRUE(
        hasTokens(sourceOf(plain, Stage::geometry), "layout(triangle_strip, max_vertices = 256) out;"));
    EXPECT_EQ("triangles", plain.geometryInput);
    request.geometryInput = "lines_adjacency";
    request.geometryOutput = "line_strip";
    request.geometryVerticesOut = 5;
    const TranslatedProgram given = translate(request);
    EXPECT_TRUE(hasTokens(sourceOf(given, Stage::geometry), "layout(lines_adjacency) in;"));
    EXPECT_TRUE(hasTokens(sourceOf(given, Stage::geometry), "layout(line_strip, max_vertices = 5) out;"));
    EXPECT_EQ("lines_adjacency", given.geometryInput);
    EXPECT_EQ("", ids(given.diagnostics));
}

TEST(Geometry, OnlyWhatIsMissingIsSynthesised) {
    const TranslatedProgram translated =
        translateSingle(Stage::geometry,
                        "#version 330\nlayout(points) in;\nlayout(points) out;\nvoid main() { gl_Position = "
                        "gl_in[0].gl_Position; EmitVertex(); }");
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::geometry), "layout(max_vertices = 256) out;"));
    EXPECT_EQ("points", translated.geometryInput);
}

TEST(Geometry, LayoutWinsOverCommands) {
    ProgramRequest request = single(Stage::geometry,
                                    "layout(triangles) in; layout(line_strip, max_vertices = 4) out;\nvoid "
                                    "main() { gl_Position = gl_PositionIn[0]; EmitVertex(); }");
    request.geometryInput = "lines";
    request.geometryOutput = "line_strip";
    request.geometryVerticesOut = 9;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("glsl-W16 glsl-W16", ids(translated.diagnostics));
    EXPECT_EQ("GeometryInput lines ignored, the shader's layout says triangles",
              textOf(translated.diagnostics, "glsl-W16"));
    EXPECT_EQ("triangles", translated.geometryInput);
}

TEST(Geometry, TooManyVerticesAreLowered) {
    const TranslatedProgram translated = translateSingle(
        Stage::geometry,
        "layout(triangles) in; layout(triangle_strip, max_vertices = 1024) out;\nout float gLight;\nvoid "
        "main() { gLight = 1.; gl_Position = gl_PositionIn[0]; EmitVertex(); }");
    EXPECT_EQ("max_vertices 1024 lowered to 204 (5 components per vertex)",
              textOf(translated.diagnostics, "glsl-W07"));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::geometry), "max_vertices = 204"));
}

TEST(Geometry, MacroOfTheVertexCountIsLoweredAtItsUse) {
    const TranslatedProgram translated = translateSingle(
        Stage::geometry,
        "#define MANY 2000\nlayout(triangles) in; layout(triangle_strip, max_vertices = MANY) out;\nvoid "
        "main() { gl_Position = gl_PositionIn[0]; int i = MANY; EmitVertex(); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::geometry), "max_vertices = 256"));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::geometry), "int i = 2000;"));
}

TEST(Geometry, BuiltinVaryingsCountAsComponents) {
    const ProgramRequest request = program(
        {{Stage::vertex, kPlainVertex},
         {Stage::geometry,
          kOld + "void main() { gl_FrontColor = vec4(1.); gl_Position = gl_PositionIn[0]; EmitVertex(); }\n"},
         {Stage::fragment, "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n"}});
    EXPECT_TRUE(hasTokens(sourceOf(translate(request), Stage::geometry), "max_vertices = 128"));
}

TEST(Geometry, WhatHasNoEquivalentIsRefused) {
    const auto message = [](const std::string& body) {
        return textOf(translateSingle(Stage::geometry, kOld + body).diagnostics, "glsl-E03");
    };
    EXPECT_NE("", message("void main() { int l = gl_LayerIn[0]; }"));
    EXPECT_NE("", message("void main() { vec4 c = gl_ClipVertexIn[0]; }"));
    EXPECT_NE("", message("void f(vec4 p[3]) {} void main() { f(gl_PositionIn); }"));
}

TEST(Geometry, MacrosAroundInputsWork) {
    const TranslatedProgram translated =
        translateSingle(Stage::geometry, kOld +
                                             "#define P gl_PositionIn\n#define AT(i) gl_PositionIn[i]\nvoid "
                                             "main() { gl_Position = P[0] + AT(1); EmitVertex(); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::geometry),
                          "gl_Position = gl_in[0].gl_Position + gl_in[1].gl_Position;"));
    EXPECT_EQ("", ids(translated.diagnostics));
}

TEST(Geometry, WrittenInputIsCopied) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvarying vec3 vN; void main() { vN = gl_Normal; gl_Position = gl_Vertex; }\n"},
         {Stage::geometry,
          kOld + "varying in vec3 vN[gl_VerticesIn]; varying out vec3 gN;\nvoid main() { vN[0] = "
                 "normalize(vN[0]); gN = vN[0]; gl_Position = gl_PositionIn[0]; EmitVertex(); }\n"},
         {Stage::fragment, "#version 120\nvarying vec3 gN; void main() { gl_FragColor = vec4(gN, 1.); }\n"}});
    EXPECT_EQ("glsl-W22", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Geometry, PerVertexBlockLosesOldMembers) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 150 compatibility\nvoid main() { gl_FrontColor = gl_Color; gl_Position = gl_Vertex; }\n"},
         {Stage::geometry,
          "#version 150 compatibility\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) "
          "out;\nin gl_PerVertex { vec4 gl_Position; vec4 gl_FrontColor; } gl_in[];\nout gl_PerVertex { vec4 "
          "gl_Position; vec4 gl_FrontColor; };\nvoid main() { gl_FrontColor = gl_in[0].gl_FrontColor; "
          "gl_Position = gl_in[0].gl_Position; EmitVertex(); }\n"},
         {Stage::fragment, "#version 150 compatibility\nvoid main() { gl_FragColor = gl_Color; }\n"}});
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Tessellation, ControlWithoutEvaluationIsRefused) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kPlainVertex},
                         {Stage::tessControl, "#version 400\nlayout(vertices = 3) out;\nvoid main() { }\n"},
                         {Stage::fragment, kPlainFragment}});
    EXPECT_EQ("TessControl without TessEvaluation", textOf(translated.diagnostics, "glsl-E06"));
    EXPECT_EQ(7, placeOf(translated.diagnostics, "glsl-E06").line);
    EXPECT_TRUE(translated.stages.empty());
}

TEST(Tessellation, FactsComeFromTheLayouts) {
    const auto facts = [](const std::string& layout) {
        return translateStages(
            {{Stage::vertex, kPlainVertex},
             {Stage::tessControl,
              "#version 400\n#extension GL_ARB_tessellation_shader : enable\nlayout(vertices = 16) "
              "out;\nvoid main() { gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position; "
              "gl_TessLevelOuter[0] = 1.; }\n"},
             {Stage::tessEvaluation, "#version 400\nlayout(" + layout +
                                         ") in;\nvoid main() { gl_Position = gl_in[0].gl_Position; }\n"},
             {Stage::fragment, kPlainFragment}});
    };
    EXPECT_EQ(16, facts("quads, equal_spacing").patchVertices);
    EXPECT_EQ("triangles", facts("quads, equal_spacing").tessellationOutput);
    EXPECT_EQ("lines", facts("isolines").tessellationOutput);
    EXPECT_EQ("points", facts("triangles, point_mode").tessellationOutput);
    EXPECT_EQ("", glslangErrors(facts("quads, equal_spacing, ccw")));
}

TEST(Facts, PointSizeAndClipDistancesOfTheLastStage) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "void main() { gl_PointSize = 2.; gl_ClipDistance[0] = 1.; gl_ClipDistance[2] = 1.; "
                        "gl_Position = aVertex; }");
    EXPECT_TRUE(translated.writesPointSize);
    EXPECT_EQ(3, translated.clipDistances);
    EXPECT_FALSE(translateSingle(Stage::vertex, "void main() { gl_Position = aVertex; }").writesPointSize);
    EXPECT_EQ(2, translateSingle(Stage::vertex,
                                 "out float gl_ClipDistance[2];\nvoid main() { for (int i = 0; i < 2; i++) "
                                 "gl_ClipDistance[i] = 1.; gl_Position = aVertex; }")
                     .clipDistances);
}

}  // namespace
}  // namespace glibra::glsl::test
