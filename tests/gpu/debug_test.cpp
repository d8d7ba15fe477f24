#include "gpu/context/driver_reports.h"

#include "fixture.h"
#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

class DebugTest : public test::GpuTest {};

TEST_F(DebugTest, AFaultyCallIsCaughtWithTheScenesPlace) {
    DebugLog& log = context().debugLog();
    log.setPlace({"sphere.glib", 7, 3});
    glBindBuffer(GL_TEXTURE_2D, 0);
    log.setPlace({});
    log.check("glBindBuffer");
    EXPECT_TRUE(log.hasError());
    const Diagnostics problems = log.takeDiagnostics();
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "gpu-E02");
    EXPECT_NE(problems[0].text.find("GL_INVALID_ENUM"), std::string::npos) << problems[0].text;
    if (log.callsBack()) {
        EXPECT_EQ(problems[0].place, (Place{"sphere.glib", 7, 3}));
    }
    EXPECT_FALSE(log.hasError());
    clearErrors();
}

TEST_F(DebugTest, WithoutCallbacksErrorsAreAskedFor) {
    DebugLog log;
    log.attach(false);
    ASSERT_FALSE(log.callsBack());
    glBindBuffer(GL_TEXTURE_2D, 0);
    log.setPlace({"cone.glib", 2, 1});
    log.check("glBindBuffer");
    const std::vector<DebugMessage> messages = log.take();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].severity, Severity::error);
    EXPECT_EQ(messages[0].text, "GL_INVALID_ENUM in glBindBuffer");
    EXPECT_EQ(messages[0].place.line, 2);
    log.check("nothing");
    EXPECT_TRUE(log.take().empty());
    (void)context().debugLog().take();
}

TEST_F(DebugTest, AShaderThatDoesNotCompileIsNoErrorOfOurs) {
    const std::array<StageSource, 1> stages{{{GL_FRAGMENT_SHADER, "#version 410 core\nnonsense"}}};
    EXPECT_FALSE(buildProgram(driver(), {.stages = stages}).program);
    EXPECT_TRUE(context().debugLog().takeDiagnostics().empty());
}

TEST(DebugLog, KeepsABoundedNumberOfMessages) {
    DebugLog log;
    for (std::size_t i = 0; i < DebugLog::kMost + 5; ++i) log.add({.severity = Severity::warning});
    EXPECT_EQ(log.take().size(), DebugLog::kMost);
    EXPECT_TRUE(log.take().empty());
}

TEST(DebugLog, OnlyErrorsBecomeDiagnostics) {
    DebugLog log;
    log.add({.severity = Severity::note, .text = "buffer moved"});
    log.add({.severity = Severity::warning, .text = "slow path"});
    log.add({.severity = Severity::error, .text = "no room", .outOfMemory = true});
    const Diagnostics problems = log.takeDiagnostics();
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "draw-E05");
}

TEST(Errors, HaveTheNamesOfTheSpecification) {
    EXPECT_EQ(errorName(0x0500), "GL_INVALID_ENUM");
    EXPECT_EQ(errorName(0x0501), "GL_INVALID_VALUE");
    EXPECT_EQ(errorName(0x0502), "GL_INVALID_OPERATION");
    EXPECT_EQ(errorName(0x0505), "GL_OUT_OF_MEMORY");
    EXPECT_EQ(errorName(0x0506), "GL_INVALID_FRAMEBUFFER_OPERATION");
    EXPECT_EQ(errorName(9), "error 9");
}

TEST(Errors, LackOfMemoryHasTheIdOfDrawing) {
    EXPECT_EQ(allocationError(0x0505, "a buffer").id, "draw-E05");
    EXPECT_EQ(allocationError(0x0502, "a buffer").id, "gpu-E02");
}

}  // namespace
}  // namespace glibra::gpu
