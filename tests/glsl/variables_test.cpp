// Colours, texture coordinates, fog, fixed state and fragment outputs (language, 7.6).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::string kColorVertex =
    "#version 120\nvoid main() { gl_FrontColor = gl_Color * 2.; gl_Position = ftransform(); }\n";
const std::string kColorFragment = "#version 120\nvoid main() { gl_FragColor = gl_Color; }\n";

TEST(Colors, ConnectVertexAndFragmentStage) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kColorVertex}, {Stage::fragment, kColorFragment}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, AreClampedWhenTheyLeaveTheLastStage) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kColorVertex}, {Stage::fragment, kColorFragment}});
    const std::string source = sourceOf(translated, Stage::vertex);
    EXPECT_TRUE(hasTokens(source, "glibra_out.FrontColor = clamp(glibra_FrontColor, 0., 1.);"));
    EXPECT_TRUE(hasTokens(source, "void glibra_main() { glibra_FrontColor = glibra_Color * 2.;"));
}

TEST(Colors, AreNotClampedBetweenOtherStages) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kColorVertex},
                         {Stage::geometry,
                          "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvoid main() { for (int "
                          "i = 0; i < gl_VerticesIn; i++) { gl_FrontColor = gl_FrontColorIn[i]; gl_Position "
                          "= gl_PositionIn[i]; EmitVertex(); } EndPrimitive(); }\n"},
                         {Stage::fragment, kColorFragment}});
    EXPECT_EQ(std::string::npos, sourceOf(translated, Stage::vertex).find("clamp"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::geometry),
                          "glibra_out.FrontColor = clamp(glibra_FrontColor, 0., 1.);"));
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::geometry), "glibra_FrontColor = glibra_in[i].FrontColor;"));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::geometry), "glibra_EmitVertex();"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, BackColorIsTakenOnBackFaces) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvoid main() { gl_FrontColor = vec4(1.); gl_BackColor = vec4(0.); "
          "gl_FrontSecondaryColor = gl_SecondaryColor; gl_Position = ftransform(); }\n"},
         {Stage::fragment, "#version 120\nvoid main() { gl_FragColor = gl_Color + gl_SecondaryColor; }\n"}});
    EXPECT_TRUE(
        hasTokens(sourceOf(translated, Stage::fragment),
                  "vec4 glibra_Color = gl_FrontFacing ? glibra_in.FrontColor : glibra_in.BackColor;"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment),
                          "vec4 glibra_SecondaryColor = glibra_in.FrontSecondaryColor;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, UnwrittenColorIsTheCurrentOne) {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kPlainVertex}, {Stage::fragment, kColorFragment}});
    EXPECT_EQ("gl_Color is written by no stage", textOf(translated.diagnostics, "glsl-W13"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "uniform vec4 glibra_CurrentColor;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, StageInBetweenThatDoesNotWriteHidesThem) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex, kColorVertex},
         {Stage::geometry,
          "#version 150\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\nvoid main() { "
          "for (int i = 0; i < 3; i++) { gl_Position = gl_in[i].gl_Position; EmitVertex(); } }\n"},
         {Stage::fragment, kColorFragment}});
    EXPECT_TRUE(has(translated.diagnostics, "glsl-W13"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, FlatMakesThemFlat) {
    ProgramRequest request = program({{Stage::vertex, kColorVertex}, {Stage::fragment, kColorFragment}});
    request.flatColors = true;
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "flat vec4 FrontColor;"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "flat vec4 FrontColor;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, KeepTheirOwnInterpolation) {
    ProgramRequest request = program(
        {{Stage::vertex,
          "#version 130\nflat out vec4 gl_FrontColor;\nnoperspective out vec4 gl_FrontSecondaryColor;\n"
          "centroid out vec4 gl_TexCoord[1];\nvoid main() { gl_FrontColor = gl_Color; "
          "gl_FrontSecondaryColor = gl_Color.bgra; gl_TexCoord[0] = gl_MultiTexCoord0; gl_Position = "
          "ftransform(); }\n"},
         {Stage::fragment,
          "#version 130\nflat in vec4 gl_Color;\nnoperspective in vec4 gl_SecondaryColor;\n"
          "centroid in vec4 gl_TexCoord[1];\nvoid main() { gl_FragColor = gl_Color + gl_SecondaryColor + "
          "gl_TexCoord[0]; }\n"}});
    for (const bool flatColors : {false, true}) {
        request.flatColors = flatColors;
        const TranslatedProgram translated = translate(request);
        for (const Stage stage : {Stage::vertex, Stage::fragment}) {
            const std::string source = sourceOf(translated, stage);
            EXPECT_TRUE(hasTokens(source, "flat vec4 FrontColor;"));
            EXPECT_TRUE(hasTokens(source, "noperspective vec4 FrontSecondaryColor;"));
            EXPECT_TRUE(hasTokens(source, stage == Stage::vertex ? "centroid out vec4 TexCoord[1];"
                                                                 : "centroid in vec4 TexCoord[1];"));
        }
        EXPECT_EQ("", glslangErrors(translated));
    }
}

TEST(Colors, OfOneStageAloneAreInterpolatedAsItSays) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 130\nsmooth out vec4 gl_FrontColor;\nvoid main() { gl_FrontColor = "
          "gl_FrontSecondaryColor = "
          "gl_Color; gl_Position = ftransform(); }\n"},
         {Stage::fragment,
          "#version 130\nflat in vec4 gl_SecondaryColor;\nvoid main() { gl_FragColor = gl_Color + "
          "gl_SecondaryColor; }\n"}});
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex),
                          "smooth vec4 FrontColor; flat vec4 FrontSecondaryColor;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Colors, GoThroughTessellation) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex, kColorVertex},
         {Stage::tessControl,
          "#version 400 compatibility\nlayout(vertices = 3) out;\nvoid main() { "
          "gl_out[gl_InvocationID].gl_FrontColor = gl_in[gl_InvocationID].gl_FrontColor; "
          "gl_out[gl_InvocationID].gl_TexCoord[1] = vec4(1.); gl_out[gl_InvocationID].gl_Position = "
          "gl_in[gl_InvocationID].gl_Position; gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = "
          "gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 2.; }\n"},
         {Stage::tessEvaluation,
          "#version 400 compatibility\nlayout(triangles) in;\nvoid main() { gl_FrontColor = "
          "gl_in[0].gl_FrontColor * gl_TessCoord.x; gl_Position = gl_in[0].gl_Position; gl_TexCoord[0] = "
          "gl_in[1].gl_TexCoord[1]; }\n"},
         {Stage::fragment,
          "#version 400 compatibility\nvoid main() { gl_FragColor = gl_Color + gl_TexCoord[0]; }\n"}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TexCoord, SizeFollowsTheIndices) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvoid main() { gl_TexCoord[0] = gl_MultiTexCoord0; gl_TexCoord[2] = vec4(1.); "
          "gl_Position = ftransform(); }\n"},
         {Stage::fragment, "#version 120\nvoid main() { gl_FragColor = gl_TexCoord[2]; }\n"}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "vec4 TexCoord[3];"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "vec4 TexCoord[3];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TexCoord, VariableIndexTakesEight) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvarying vec4 gl_TexCoord[2];\nvoid main() { for (int i = 0; i < 2; i++) "
          "gl_TexCoord[i] = vec4(i); gl_Position = ftransform(); }\n"},
         {Stage::fragment, "#version 120\nvoid main() { gl_FragColor = gl_TexCoord[1]; }\n"}});
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "vec4 TexCoord[8];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TexCoord, RedeclarationGivesTheSizeAndGoes) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvarying vec4 gl_TexCoord[4];\nvoid main() { gl_TexCoord[0] = vec4(1.); gl_Position "
          "= ftransform(); }\n"},
         {Stage::fragment,
          "#version 120\nvarying vec4 gl_TexCoord[4];\nvoid main() { gl_FragColor = gl_TexCoord[0]; }\n"}});
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "vec4 TexCoord[4];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TexCoord, UnwrittenElementIsReportedAndHasADefault) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvoid main() { gl_TexCoord[0] = vec4(1.); gl_Position = ftransform(); }\n"},
         {Stage::fragment,
          "#version 120\nvoid main() { gl_FragColor = gl_TexCoord[0] + gl_TexCoord[1] + "
          "vec4(gl_FogFragCoord); }\n"}});
    EXPECT_EQ("glsl-W13 glsl-W13", ids(translated.diagnostics));
    EXPECT_EQ("gl_TexCoord[1] is written by no stage", textOf(translated.diagnostics, "glsl-W13"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "float glibra_FogFragCoord = 0.;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TexCoord, GeometryStageReadsBothIndices) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvoid main() { gl_TexCoord[0] = gl_MultiTexCoord0; gl_FogFragCoord = 1.; gl_Position "
          "= ftransform(); }\n"},
         {Stage::geometry,
          "#version 120\n#extension GL_EXT_geometry_shader4 : enable\nvoid main() { for (int i = 0; i < 3; "
          "++i) { gl_TexCoord[0] = gl_TexCoordIn[i][0]; gl_FogFragCoord = gl_FogFragCoordIn[i]; gl_BackColor "
          "= gl_BackColorIn[i]; gl_Position = gl_PositionIn[i]; EmitVertex(); } }\n"},
         {Stage::fragment,
          "#version 120\nvoid main() { gl_FragColor = gl_TexCoord[0] * gl_FogFragCoord; }\n"}});
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::geometry), "glibra_TexCoord[0] = glibra_in[i].TexCoord[0];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(FixedState, IsConstantAndReported) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 120\nvoid main() { gl_LightSourceParameters l = gl_LightSource[0]; gl_FragColor = "
        "l.diffuse * gl_FrontMaterial.diffuse + gl_LightModel.ambient + gl_FrontLightModelProduct.sceneColor "
        "+ gl_FrontLightProduct[0].diffuse + gl_Fog.color + gl_ClipPlane[0] + gl_TextureEnvColor[1] + "
        "gl_EyePlaneS[0] + gl_ObjectPlaneT[1] + vec4(gl_NormalScale + gl_Point.size); }");
    const std::string source = sourceOf(translated, Stage::fragment);
    EXPECT_EQ("gl_LightSource has GL's initial values; scenes define no lights",
              textOf(translated.diagnostics, "glsl-W04"));
    EXPECT_TRUE(
        hasTokens(source,
                  "const glibra_MaterialParameters glibra_FrontMaterial = glibra_MaterialParameters(vec4(0., "
                  "0., 0., 1.), vec4(.2, .2, .2, 1.), vec4(.8, .8, .8, 1.)"));
    EXPECT_TRUE(hasTokens(source, "uniform float glibra_PointSize;"));
    EXPECT_EQ(std::string::npos, source.find("glibra_BackMaterial"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(FixedState, LimitsAreConstants) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 120\nvoid main() { float a[gl_MaxLights]; a[0] = float(gl_MaxTextureUnits + "
        "gl_MaxClipPlanes + gl_MaxTextureCoords + gl_MaxVaryingFloats); gl_FragColor = vec4(a[0]); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(FixedState, ClipVertexHasNoEffect) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "#version 120\nvoid main() { gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex; "
                        "gl_Position = ftransform(); }");
    EXPECT_EQ("glsl-W17", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(FixedState, CoreNamesStay) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nvoid main() { gl_FragDepth = gl_FragCoord.z; gl_FragColor = "
                        "gl_FrontFacing ? vec4(gl_PointCoord, gl_DepthRange.near, 1.) : vec4(0.); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Outputs, FragColorGoesToEveryTarget) {
    ProgramRequest request = single(Stage::fragment,
                                    "#version 120\nvoid main() { if (gl_FragCoord.x < 1.) { gl_FragColor = "
                                    "vec4(1.); return; } gl_FragColor = vec4(0.); }");
    request.colorTargets = 3;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ(3, translated.fragmentOutputs);
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "glibra_FragColors[2] = glibra_FragColor;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Outputs, FragDataCountsItsIndices) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 120\nvoid main() { gl_FragData[0] = vec4(1.); gl_FragData[2] = vec4(0.); }");
    EXPECT_EQ(3, translated.fragmentOutputs);
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment),
                          "layout(location = 0) out vec4 glibra_FragData[3];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Outputs, MixingIsRefused) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "out vec4 fFragColor;\nvoid main() { gl_FragColor = vec4(1.); fFragColor = vec4(0.); }");
    EXPECT_EQ("gl_FragColor and the output 'fFragColor' cannot be mixed",
              textOf(translated.diagnostics, "glsl-E10"));
    EXPECT_EQ(2, placeOf(translated.diagnostics, "glsl-E10").line);
}

TEST(Outputs, UnusedOwnOutputGivesWay) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment, "out vec4 fFragColor;\nvoid main() { gl_FragColor = vec4(1.); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Outputs, LocationsFollowTheOrderAndSkipUsedOnes) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "out vec4 a; layout(location = 1) out vec4 b; out vec4 c[2], d;\nvoid main() { a = b "
                        "= c[0] = c[1] = d = vec4(1.); }");
    const std::string text = userPart(translated, Stage::fragment);
    EXPECT_TRUE(hasTokens(text,
                          "layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; layout(location "
                          "= 2) out vec4 c[2]; layout(location = 4) out vec4 d;"));
    EXPECT_EQ(5, translated.fragmentOutputs);
    EXPECT_EQ("", glslangErrors(translated));
}

}  // namespace
}  // namespace glibra::glsl::test
