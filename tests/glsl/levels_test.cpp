// Which uniforms decide tessellation levels and nothing else, as far as a program's text shows it.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::string kEvaluation = "layout(triangles) in;\nvoid main() { gl_Position = vec4(0.); }";

/// The level uniforms of a program whose control stage has the uniforms uA and uB and this main.
std::string levels(const std::string& controlMain, const std::string& evaluation = kEvaluation,
                   std::vector<std::pair<Stage, std::string>> more = {}) {
    std::vector<std::pair<Stage, std::string>> stages = {
        {Stage::vertex, kPlainVertex},
        {Stage::tessControl,
         "#version 410 core\nlayout(vertices = 3) out;\nuniform float uA, uB; // levels\n"
         "out vec4 tcColor[];\nfloat scale(float x) { return 2. * x; }\nvoid main() {\n" +
             controlMain + "\n}\n"},
        {Stage::tessEvaluation, "#version 410 core\n" + evaluation},
        {Stage::fragment, kPlainFragment}};
    for (auto& each : more) stages.push_back(std::move(each));
    const TranslatedProgram translated = translateStages(std::move(stages));
    EXPECT_FALSE(hasError(translated.diagnostics)) << ids(translated.diagnostics);
    std::string all;
    for (const std::string& each : translated.levelUniforms) all += each;
    return all;
}

TEST(LevelUniforms, ReachLevelsDirectly) {
    EXPECT_EQ(levels("gl_TessLevelOuter[0] = gl_TessLevelOuter[2] = uA;\n"
                     "gl_TessLevelInner[0] = 2. * max(uB, 1.);"),
              "uAuB");
}

TEST(LevelUniforms, MayGoThroughLocalVariables) {
    EXPECT_EQ(levels("float size = 3.;\nfloat level = max(uA * size, 3.), other = level;\n"
                     "gl_TessLevelOuter[1] = level;"),
              "");  // two variables in one declaration are not understood
    EXPECT_EQ(levels("float size = 3.;\nfloat level = max(uA * size, 3.);\nlevel *= 2.;\n"
                     "if (gl_InvocationID == 0) gl_TessLevelOuter[1] = level;"),
              "uA");
}

TEST(LevelUniforms, MayReachLevelsInALoop) {
    EXPECT_EQ(levels("for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uA;\n"
                     "for (int i = 0; i < 2; ++i) {\n    gl_TessLevelInner[i] = max(uB, 1.);\n}"),
              "uAuB");
    EXPECT_EQ(levels("for (int i = 0; i < 4; ++i) { gl_TessLevelOuter[i] = uA; tcColor[i].x = uA; }"), "");
    EXPECT_EQ(levels("if (gl_InvocationID == 0) for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uA;"),
              "uA");
    EXPECT_EQ(levels("if (uA > 1.) for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uA;"), "");
    EXPECT_EQ(levels("int i = 0; while (i < 4) { gl_TessLevelOuter[i] = uA; ++i; }"), "uA");
    EXPECT_EQ(levels("int i = 0; while (float(i) < uA) { gl_TessLevelOuter[i] = uA; ++i; }"), "");
}

TEST(LevelUniforms, ReachNothingElse) {
    for (const char* text :
         {"gl_TessLevelOuter[0] = uA; tcColor[gl_InvocationID] = vec4(uA);",
          "float level = uA; gl_TessLevelOuter[0] = level; tcColor[gl_InvocationID].x = level;",
          "gl_TessLevelOuter[0] = uA; tcColor[gl_InvocationID].x = gl_TessLevelOuter[0];",
          "gl_TessLevelOuter[0] = uA; if (uA > 3.) tcColor[gl_InvocationID].x = 1.;",
          "gl_TessLevelOuter[int(uA)] = 3.;", "gl_TessLevelOuter[0] = scale(uA);",
          "float l = uA; gl_TessLevelOuter[0] = l++;",
          "for (float x = 0.; x < uA; x += 1.) gl_TessLevelOuter[0] += 1.;",
          "gl_TessLevelOuter[0] = uA > 3. ? 4. : 5.;",
          "#define X tcColor[gl_InvocationID].x = uA\ngl_TessLevelOuter[0] = uA;\nX;"})
        EXPECT_EQ(levels(text), "") << text;
}

TEST(LevelUniforms, AreReadInNoOtherStage) {
    const std::string control = "gl_TessLevelOuter[0] = uA; gl_TessLevelInner[0] = uB;";
    EXPECT_EQ(levels(control, "layout(triangles) in;\nuniform float uA; void main() { gl_Position.x = uA; }"),
              "uB");
    EXPECT_EQ(levels(control, "layout(triangles) in;\nvoid main() { gl_Position.x = gl_TessLevelOuter[0]; }"),
              "");
}

TEST(LevelUniforms, DoNotExistWhereTrianglesOrVerticesAreShown) {
    const std::string control = "gl_TessLevelOuter[0] = uA;";
    EXPECT_EQ(levels(control), "uA");
    EXPECT_EQ(levels(control, "layout(triangles, point_mode) in;\nvoid main() { gl_Position = vec4(0.); }"),
              "");
    EXPECT_EQ(levels(control, kEvaluation,
                     {{Stage::geometry,
                       "#version 410 core\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\n"
                       "void main() { EmitVertex(); }"}}),
              "");
}

TEST(LevelUniforms, AreScalars) {
    EXPECT_EQ(levels("gl_TessLevelOuter[0] = uV.x;\n}\nuniform vec2 uV;\nvoid other() {"), "");
}

TEST(LevelUniforms, CommentsAndUnusedMacrosAreNoUses) {
    EXPECT_EQ(levels("gl_TessLevelOuter[0] = uA; /* tcColor = uA; */ // if (uA)"), "uA");
    EXPECT_EQ(levels("gl_TessLevelOuter[0] = uA;\n#define X tcColor[0] = uA\n"), "uA");
}

}  // namespace
}  // namespace glibra::glsl::test
