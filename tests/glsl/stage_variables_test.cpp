#include "glsl/facts/stage_variables.h"

#include <gtest/gtest.h>

namespace glibra::test {
namespace {

using glsl::StageVariable;

std::string listed(const std::string& source) {
    glsl::TranslatedStage stage;
    stage.stage = glsl::Stage::fragment;
    stage.source = source;
    std::string all;
    for (const StageVariable& each : glsl::stageVariables(stage, {{"glibra_filter", "filter"}})) {
        all += (each.isOutput ? "out " : "in ") + each.type + " " + each.name + " = " + each.expression;
        if (each.elements > 0) all += " x " + std::to_string(each.elements);
        all += "\n";
    }
    return all;
}

TEST(StageVariables, ListsInputsAndOutputsWithTheNamesOfTheUser) {
    EXPECT_EQ(
        listed("#version 450 core\nuniform vec4 uColor;\nflat in int vId; in vec3 vA, vB[2];\n"
               "layout(location = 0) out vec4 c;\nin vec4 glibra_TexCoord[3];\nin float glibra_filter;\n"
               "#define SIZE 4\nin float vList[SIZE];\nvoid main() { vec3 local; }\n"),
        "in int vId = vId\nin vec3 vA = vA\nin vec3 vB = vB x 2\nout vec4 c = c\n"
        "in vec4 gl_TexCoord = glibra_TexCoord x 3\nin float filter = glibra_filter\n"
        "in float vList = vList x 4\n");
}

TEST(StageVariables, ListsMembersOfBlocks) {
    EXPECT_EQ(listed("#version 450 core\nin Surface { vec3 normal; mat3 frame; } s;\nin Plain { vec2 uv; };\n"
                     "in glibra_Varyings_V { vec4 FrontColor; vec4 TexCoord[2]; } glibra_in;\n"),
              "in vec3 s.normal = s.normal\nin mat3 s.frame = s.frame\nin vec2 uv = uv\n"
              "in vec4 gl_FrontColor = glibra_in.FrontColor\nin vec4 gl_TexCoord = glibra_in.TexCoord x 2\n");
}

TEST(StageVariables, LeavesOutWhatHasNoNumbers) {
    EXPECT_EQ(
        listed(
            "#version 450 core\nstruct S { vec3 a; };\nin S vS; in float vUnknown[]; in vec2 vTwice[2][3];\n"
            "in Many { vec3 a; } many[2];\nin vec4 gl_FragCoord;\n"),
        "");
}

TEST(StageVariables, ReadsNumbersColumnByColumn) {
    const StageVariable matrix{"m", "m", "mat3", 0, false};
    EXPECT_EQ(matrix.components(), 9);
    EXPECT_EQ(matrix.number(0, 5), "float(m[1][2])");
    const StageVariable list{"v", "b.v", "ivec2", 4, false};
    EXPECT_EQ(list.number(3, 1), "float(b.v[3][1])");
    const StageVariable scalar{"f", "f", "bool", 0, true};
    EXPECT_EQ(scalar.number(0, 0), "float(f)");
}

}  // namespace
}  // namespace glibra::test
