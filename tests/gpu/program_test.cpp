#include "gpu/object/program.h"

#include <fmt/format.h>

#include "fixture.h"

namespace glibra::gpu {
namespace {

class ProgramTest : public test::GpuTest {};

constexpr std::string_view kPlain =
    "#version 410 core\nout vec4 fColor;\nvoid main() { fColor = vec4(1); }\n";

TEST_F(ProgramTest, AMistakeIsInTheLogOfItsStage) {
    const std::array<StageSource, 2> stages{
        {{GL_VERTEX_SHADER, test::kCoverAll},
         {GL_FRAGMENT_SHADER,
          "#version 410 core\nout vec4 fColor;\nvoid main() { fColor = unknownName; }\n"}}};
    const BuildOutcome outcome = buildProgram(driver(), {.stages = stages});
    EXPECT_FALSE(outcome.program);
    ASSERT_EQ(outcome.stages.size(), 2U);
    EXPECT_TRUE(outcome.stages[0].compiled);
    EXPECT_FALSE(outcome.stages[1].compiled);
    EXPECT_NE(outcome.stages[1].log.find("unknownName"), std::string::npos) << outcome.stages[1].log;
}

TEST_F(ProgramTest, StagesThatDoNotFitFailAtTheLink) {
    const std::array<StageSource, 2> stages{
        {{GL_VERTEX_SHADER,
          "#version 410 core\nout vec2 vPlace;\nvoid main() { vPlace = vec2(0); gl_Position = vec4(0); }"},
         {GL_FRAGMENT_SHADER,
          "#version 410 core\nin vec3 vPlace;\nout vec4 fColor;\nvoid main() { fColor = vec4(vPlace, 1); "
          "}"}}};
    const BuildOutcome outcome = buildProgram(driver(), {.stages = stages});
    EXPECT_FALSE(outcome.program);
    for (const StageLog& each : outcome.stages) EXPECT_TRUE(each.compiled);
    EXPECT_NE(outcome.linkLog.find("vPlace"), std::string::npos) << outcome.linkLog;
}

TEST_F(ProgramTest, InputsAndOutputsGetTheLocationsAskedFor) {
    const std::array<StageSource, 2> stages{{{GL_VERTEX_SHADER,
                                              "#version 410 core\nin vec4 aSecond;\nin vec4 aFirst;\nvoid "
                                              "main() { gl_Position = aFirst + aSecond; }"},
                                             {GL_FRAGMENT_SHADER,
                                              "#version 410 core\nout vec4 fOne;\nout vec4 fTwo;\nvoid "
                                              "main() { fOne = vec4(1); fTwo = vec4(2); }"}}};
    const BuildOutcome outcome = buildProgram(driver(), {.stages = stages,
                                                         .vertexInputs = {{"aFirst", 5}, {"aSecond", 2}},
                                                         .fragmentOutputs = {{"fOne", 1}, {"fTwo", 0}}});
    ASSERT_TRUE(outcome.program) << outcome.linkLog;
    EXPECT_EQ(glGetAttribLocation(outcome.program->id(), "aFirst"), 5);
    EXPECT_EQ(glGetAttribLocation(outcome.program->id(), "aSecond"), 2);
    EXPECT_EQ(glGetFragDataLocation(outcome.program->id(), "fOne"), 1);
    EXPECT_EQ(glGetFragDataLocation(outcome.program->id(), "fTwo"), 0);
}

TEST_F(ProgramTest, SeveralBuildsCanBeUnderWayAtOnce) {
    std::vector<std::string> texts;
    texts.reserve(4);
    for (int i = 0; i < 4; ++i)
        texts.push_back(
            fmt::format("#version 410 core\nout vec4 fColor;\nvoid main() {{ fColor = vec4({}); }}", i));
    std::vector<ProgramBuild> builds;
    for (const std::string& each : texts) {
        const std::array<StageSource, 2> stages{
            {{GL_VERTEX_SHADER, test::kCoverAll}, {GL_FRAGMENT_SHADER, each}}};
        builds.emplace_back(driver(), ProgramSource{.stages = stages});
    }
    for (std::size_t i = 0; i < builds.size(); ++i) {
        const BuildOutcome outcome = builds[i].finish();
        ASSERT_TRUE(outcome.program);
        EXPECT_EQ(shade(*outcome.program).at(0)[0], static_cast<float>(i));
    }
}

TEST_F(ProgramTest, ABuildGetsReadyByItself) {
    const std::array<StageSource, 2> stages{
        {{GL_VERTEX_SHADER, test::kCoverAll}, {GL_FRAGMENT_SHADER, kPlain}}};
    ProgramBuild started(driver(), {.stages = stages});
    while (!started.isReady()) {
    }
    EXPECT_TRUE(started.finish().program);
}

TEST_F(ProgramTest, TextsNeedNoEndingZero) {
    const std::string padded = std::string(kPlain) + "this is no GLSL";
    const std::array<StageSource, 2> stages{
        {{GL_VERTEX_SHADER, test::kCoverAll},
         {GL_FRAGMENT_SHADER, std::string_view(padded).substr(0, kPlain.size())}}};
    EXPECT_TRUE(buildProgram(driver(), {.stages = stages}).program);
}

TEST_F(ProgramTest, NoStagesAreNoProgram) {
    const BuildOutcome outcome = buildProgram(driver(), {});
    EXPECT_TRUE(outcome.stages.empty());
    (void)context().debugLog().take();
}

TEST_F(ProgramTest, SourceTextThatIsEmptyOrBinaryOnlyFails) {
    const std::string binary(200, '\x01');
    for (const std::string_view each :
         {std::string_view{}, std::string_view(binary), std::string_view("#version 9999\n")}) {
        const std::array<StageSource, 1> stages{{{GL_FRAGMENT_SHADER, each}}};
        EXPECT_FALSE(buildProgram(driver(), {.stages = stages}).program);
    }
}

TEST_F(ProgramTest, NamesAreGivenBack) {
    GLuint id = 0;
    {
        const auto program = build(test::kCoverAll, kPlain);
        ASSERT_TRUE(program);
        id = program->id();
        EXPECT_TRUE(glIsProgram(id));
    }
    EXPECT_FALSE(glIsProgram(id));
}

}  // namespace
}  // namespace glibra::gpu
