// The uniforms whose values the choice of tessellation levels may lower.

#include "budget/least_counts.h"

#include <gtest/gtest.h>

#include <vector>

namespace glibra::budget {
namespace {

/// A program with the uniforms uA (4), uB (9) and uC (0). The first and the last decide levels alone.
class Tessellated {
  public:
    Tessellated() {
        interface.facts.levelUniforms = {"uA", "uC"};
        for (const auto& [name, value] : {std::pair("uA", 4.), {"uB", 9.}, {"uC", 0.}}) {
            plan::ActiveUniform& uniform = interface.uniforms.emplace_back();
            uniform.name = name;
            uniform.location = static_cast<int>(interface.uniforms.size()) - 1;
            program.values.push_back(
                {plan::UniformIndex(interface.uniforms.size() - 1), 0, plan::Literal{{value}}});
        }
        program.interface = &interface;
    }
    Tessellated(const Tessellated&) = delete;
    Tessellated& operator=(const Tessellated&) = delete;

    plan::ProgramInterface interface;
    plan::PlannedProgram program;
};

TEST(LevelUniforms, DecideLevelsAloneAndAreAboveZero) {
    const Tessellated tessellated;
    const std::vector<LevelUniform> found = levelUniforms(tessellated.program, 32);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].uniform, plan::UniformIndex(0));
    EXPECT_EQ(found[0].value, 4);
}

TEST(LevelUniforms, AreNumbersThatTheSceneGives) {
    Tessellated tessellated;
    tessellated.program.values[0].value = plan::Literal{{4, 5}};
    EXPECT_TRUE(levelUniforms(tessellated.program, 32).empty());
    tessellated.program.values.erase(tessellated.program.values.begin());
    EXPECT_TRUE(levelUniforms(tessellated.program, 32).empty());
}

TEST(LevelUniforms, HaveTheRangesOfTheirSliders) {
    Tessellated tessellated;
    EXPECT_EQ(levelUniforms(tessellated.program, 32)[0].least, 1);
    EXPECT_EQ(levelUniforms(tessellated.program, 32)[0].most, 32);
    tessellated.program.controls.push_back({plan::UniformIndex(0), glib::UniformForm::range, 0, 4, 30});
    EXPECT_EQ(levelUniforms(tessellated.program, 32)[0].least, 1);
    EXPECT_EQ(levelUniforms(tessellated.program, 32)[0].most, 30);
    tessellated.program.controls[0].minimum = 3;
    EXPECT_EQ(levelUniforms(tessellated.program, 32)[0].least, 3);
}

}  // namespace
}  // namespace glibra::budget
