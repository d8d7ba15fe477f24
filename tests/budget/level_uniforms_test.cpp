// Which uniforms decide tessellation levels and nothing else, told by a program's text.

#include "budget/level_uniforms.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glibra::budget {
namespace {

/// A program of a vertex, a control, an evaluation and a fragment stage whose uniforms uA and uB are 4 and 9.
class Tessellated {
  public:
    explicit Tessellated(const std::string& controlMain, const std::string& evaluation = "void main() {}") {
        interface.facts.tessellationOutput = "triangles";
        interface.facts.stages = {
            {glsl::Stage::vertex, "void main() {}", {}, "a.vert", {}},
            {glsl::Stage::tessControl,
             "#version 410 core\nlayout(vertices = 3) out;\nuniform float uA, uB; // levels\n"
             "out vec4 tcColor[];\nvoid main() {\n" +
                 controlMain + "\n}\n",
             {},
             "a.tcs",
             {}},
            {glsl::Stage::tessEvaluation, evaluation, {}, "a.tes", {}},
            {glsl::Stage::fragment, "void main() {}", {}, "a.frag", {}}};
        double value = 4;
        for (const char* name : {"uA", "uB"}) {
            plan::ActiveUniform& uniform = interface.uniforms.emplace_back();
            uniform.name = name;
            uniform.location = static_cast<int>(interface.uniforms.size()) - 1;
            program.values.push_back(
                {plan::UniformIndex(interface.uniforms.size() - 1), 0, plan::Literal{{value}}});
            value += 5;
        }
        program.interface = &interface;
    }
    Tessellated(const Tessellated&) = delete;
    Tessellated& operator=(const Tessellated&) = delete;

    /// The names of those found, one after the other.
    [[nodiscard]] std::string names() const {
        std::string all;
        for (const LevelUniform& each : levelUniforms(program, 64))
            all += at(interface.uniforms, each.uniform).name;
        return all;
    }

    plan::ProgramInterface interface;
    plan::PlannedProgram program;
};

TEST(LevelUniforms, AreThoseThatReachLevelsDirectly) {
    EXPECT_EQ(Tessellated("gl_TessLevelOuter[0] = gl_TessLevelOuter[2] = uA;\n"
                          "gl_TessLevelInner[0] = 2. * max(uB, 1.);")
                  .names(),
              "uAuB");
}

TEST(LevelUniforms, MayGoByWayOfLocalVariables) {
    EXPECT_EQ(Tessellated("float size = 3.;\nfloat level = max(uA * size, 3.), other = level;\n"
                          "gl_TessLevelOuter[1] = level;")
                  .names(),
              "");  // two in one declaration are not read
    EXPECT_EQ(Tessellated("float size = 3.;\nfloat level = max(uA * size, 3.);\nlevel *= 2.;\n"
                          "if (gl_InvocationID == 0) gl_TessLevelOuter[1] = level;")
                  .names(),
              "uA");
}

TEST(LevelUniforms, AreNotThoseThatReachAnythingElse) {
    for (const char* text :
         {"gl_TessLevelOuter[0] = uA; tcColor[0] = vec4(uA);",
          "float level = uA; gl_TessLevelOuter[0] = level; tcColor[0].x = level;",
          "gl_TessLevelOuter[0] = uA; tcColor[0].x = gl_TessLevelOuter[0];",
          "gl_TessLevelOuter[0] = uA; if (uA > 3.) tcColor[0].x = 1.;", "gl_TessLevelOuter[int(uA)] = 3.;",
          "gl_TessLevelOuter[0] = scale(uA);",
          "for (float x = 0.; x < uA; x += 1.) gl_TessLevelOuter[0] += 1.;",
          "gl_TessLevelOuter[0] = uA > 3. ? 4. : 5.;", "gl_TessLevelOuter[0] = uA;\n#define X uA\n"})
        EXPECT_EQ(Tessellated(text).names(), "") << text;
}

TEST(LevelUniforms, AreReadInNoOtherStage) {
    const std::string control = "gl_TessLevelOuter[0] = uA; gl_TessLevelInner[0] = uB;";
    EXPECT_EQ(Tessellated(control, "uniform float uA; void main() { gl_Position.x = uA; }").names(), "uB");
    EXPECT_EQ(Tessellated(control, "void main() { gl_Position.x = gl_TessLevelOuter[0]; }").names(), "");
    Tessellated shrunk(control);
    shrunk.interface.facts.stages.push_back({glsl::Stage::geometry, "void main() {}", {}, "a.geom", {}});
    EXPECT_EQ(shrunk.names(), "");
    Tessellated points(control);
    points.interface.facts.tessellationOutput = "points";
    EXPECT_EQ(points.names(), "");
}

TEST(LevelUniforms, AWordInACommentIsNoUse) {
    EXPECT_EQ(Tessellated("gl_TessLevelOuter[0] = uA; /* tcColor = uA; */ // if (uA)").names(), "uA");
}

TEST(LevelUniforms, HaveTheRangesOfTheirSliders) {
    Tessellated slid("gl_TessLevelOuter[0] = uA; gl_TessLevelInner[0] = uB;");
    slid.program.controls.push_back({plan::UniformIndex(0), glib::UniformForm::range, 0, 4, 30});
    slid.program.controls.push_back({plan::UniformIndex(1), glib::UniformForm::range, 3, 9, 20});
    const std::vector<LevelUniform> found = levelUniforms(slid.program, 32);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].value, 4);
    EXPECT_EQ(found[0].least, 1);
    EXPECT_EQ(found[0].most, 30);
    EXPECT_EQ(found[1].least, 3);
    slid.program.controls.clear();
    EXPECT_EQ(levelUniforms(slid.program, 32)[0].most, 32);
}

}  // namespace
}  // namespace glibra::budget
