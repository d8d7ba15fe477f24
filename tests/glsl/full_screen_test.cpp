// Programs with a fragment stage alone, for filling a target, and with a vertex stage alone.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram fill(const std::string& fragment) {
    ProgramRequest request = program({{Stage::fragment, fragment}});
    request.suppliesFullScreenVertex = true;
    return translate(request);
}

TEST(FullScreenVertex, GivesThePlaceThatTheFragmentStageReads) {
    for (const char* declaration :
         {"#version 330\nin vec2 vST;", "#version 110\nvarying vec2 vST;", "varying vec2 vST;",
          "#version 450\nlayout(location = 0) noperspective in vec2 vST;"}) {
        const TranslatedProgram translated =
            fill(std::string(declaration) + "\nvoid main() { gl_FragColor = vec4(vST, 0., 1.); }");
        EXPECT_FALSE(hasError(translated.diagnostics));
        EXPECT_FALSE(has(translated.diagnostics, "glsl-W11"));
        EXPECT_EQ("", glslangErrors(translated)) << declaration;
        ASSERT_EQ(2U, translated.stages.size());
        EXPECT_EQ(Stage::vertex, translated.stages[0].stage);
        EXPECT_TRUE(hasTokens(translated.stages[0].source, "vST = corner;"));
        EXPECT_TRUE(translated.vertexInputs.empty());
    }
}

TEST(FullScreenVertex, GivesNothingElse) {
    const TranslatedProgram plain = fill(kPlainFragment);
    EXPECT_EQ("", ids(plain.diagnostics));
    EXPECT_EQ("", glslangErrors(plain));
    EXPECT_FALSE(hasTokens(sourceOf(plain, Stage::vertex), "vST"));
    EXPECT_FALSE(
        has(fill("#version 330\nuniform vec2 vST;\nout vec4 o;\nvoid main() { o = vST.xyxy; }").diagnostics,
            "glsl-E02"));
    const TranslatedProgram other =
        fill("#version 330\nin vec3 vN;\nout vec4 o;\nvoid main() { o = vN.xyzz; }");
    EXPECT_EQ("glsl-W11", ids(other.diagnostics));
    EXPECT_EQ(
        "glsl-E02",
        ids(fill("#version 330\nin vec3 vST;\nout vec4 o;\nvoid main() { o = vST.xyzz; }").diagnostics));
}

TEST(FullScreenVertex, OldTextureCoordinates) {
    const TranslatedProgram translated = fill(
        "#version 120\nuniform sampler2D uT;\nvoid main() { gl_FragColor = texture2D(uT, gl_TexCoord[0].st); "
        "}");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(FullScreenVertex, OnlyForAFragmentStageAlone) {
    ProgramRequest request = program({{Stage::vertex, kPlainVertex}, {Stage::fragment, kPlainFragment}});
    const std::string without = sourceOf(translate(request), Stage::vertex);
    request.suppliesFullScreenVertex = true;
    EXPECT_EQ(without, sourceOf(translate(request), Stage::vertex));
    EXPECT_EQ(1U, translateSingle(Stage::fragment, kPlainFragment).stages.size());
}

TEST(FullScreenVertex, ReplacesAVertexStageThatLacksThePlace) {
    ProgramRequest request = program(
        {{Stage::vertex, kPlainVertex},
         {Stage::fragment, "#version 330\nin vec2 vST;\nout vec4 o;\nvoid main() { o = vST.xyxy; }"}});
    EXPECT_EQ("glsl-W11", ids(translate(request).diagnostics));
    request.suppliesFullScreenVertex = true;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_TRUE(translated.suppliesVertexStage);
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "vST = corner;"));
}

TEST(FullScreenVertex, KeepsAVertexStageWithThePlace) {
    ProgramRequest request = program(
        {{Stage::vertex,
          "#version 330\nout vec2 vST;\nvoid main() { vST = aVertex.yx; gl_Position = aVertex; }"},
         {Stage::fragment, "#version 330\nin vec2 vST;\nout vec4 o;\nvoid main() { o = vST.xyxy; }"}});
    request.suppliesFullScreenVertex = true;
    const TranslatedProgram translated = translate(request);
    EXPECT_FALSE(translated.suppliesVertexStage);
    EXPECT_FALSE(hasTokens(sourceOf(translated, Stage::vertex), "vST = corner;"));
}

TEST(FullScreenVertex, TilesAndOtherTargets) {
    ProgramRequest request = program(
        {{Stage::fragment, "#version 330\nin vec2 vST;\nout vec4 o;\nvoid main() { o = vST.xyxy; }"}});
    request.suppliesFullScreenVertex = true;
    request.tiled = true;
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "uniform vec4 glibra_Tile;"));
}

TEST(FullScreenVertex, WithoutTranslation) {
    ProgramRequest request = program(
        {{Stage::fragment, "#version 330\nin vec2 vST;\nout vec4 o;\nvoid main() { o = vST.xyxy; }"}});
    request.suppliesFullScreenVertex = true;
    request.shim = false;
    EXPECT_EQ("", glslangErrors(translate(request)));
}

TEST(VertexStageAlone, IsAProgram) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 330\nout vec3 vN;\nvoid main() { vN = aNormal; gl_FrontColor = gl_Color; gl_Position = "
          "uModelViewProjectionMatrix * aVertex; }"}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_EQ(0, translated.fragmentOutputs);
    EXPECT_EQ(Placement::vertex, translated.placement);
    EXPECT_EQ(
        Placement::unknown,
        translateStages({{Stage::vertex, "void main() { gl_Position = 2. * ftransform(); }"}}).placement);
}

}  // namespace
}  // namespace glibra::glsl::test
