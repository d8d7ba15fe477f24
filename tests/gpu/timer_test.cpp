// The GPU time of pieces of work.

#include "gpu/object/timer.h"

#include <chrono>
#include <utility>

#include "fixture.h"
#include "gpu/context/call_counter.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"

namespace glibra::gpu {
namespace {

/// Pieces with their times, as they are taken.
using Taken = std::vector<std::pair<std::size_t, double>>;

class TimerTest : public test::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (driver().timerBits == 0) GTEST_SKIP() << "the driver has no timer";
    }
    Timer timer() {
        return {driver(), [this](std::size_t piece, double time) { taken.emplace_back(piece, time); }};
    }
    /// Fills a window by a loop of so many rounds.
    void fill(int rounds) {
        const std::string text =
            "#version 410 core\nout vec4 fColor;\nvoid main() {\n"
            "  float x = gl_FragCoord.x;\n  for (int i = 0; i < " +
            std::to_string(rounds) + "; ++i) x = sin(x + gl_FragCoord.y);\n  fColor = vec4(x);\n}\n";
        auto& program = programs[rounds];
        if (!program) program = build(test::kCoverAll, text);
        ASSERT_TRUE(program);
        window.bind();
        program->use();
        array.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    Taken taken;
    std::map<int, std::optional<Program>> programs;
    Target window = std::move(*Target::window(driver(), 256, 256, TexelFormat::rgba8, 1));
    VertexArray array{std::span<const AttributeSource>()};
};

TEST_F(TimerTest, HeavyWorkTakesLongerThanLightWork) {
    fill(1);
    fill(1000);
    glFinish();
    Timer each = timer();
    for (const int rounds : {1, 1000, 1}) {
        each.begin(static_cast<std::size_t>(rounds));
        fill(rounds);
        each.end();
    }
    each.finish();
    ASSERT_EQ(taken.size(), 3U);
    EXPECT_EQ(taken[0].first, 1U);
    EXPECT_EQ(taken[1].first, 1000U);
    EXPECT_GT(taken[1].second, 10 * taken[2].second) << taken[0].second;
    EXPECT_GE(taken[2].second, 0);
}

TEST_F(TimerTest, ADispatchIsMeasuredByItself) {
    if (!driver().compute) GTEST_SKIP() << "needs GL 4.3";
    const std::array<StageSource, 1> stages{{{GL_COMPUTE_SHADER, R"(#version 430 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Values { float values[]; };
void main() {
    float x = float(gl_GlobalInvocationID.x);
    for (int i = 0; i < 1000; ++i) x = sin(x + 1.);
    values[gl_GlobalInvocationID.x] = x;
})"}}};
    const BuildOutcome outcome = buildProgram(driver(), {.stages = stages});
    ASSERT_TRUE(outcome.program) << outcome.linkLog;
    const auto buffer = Buffer::create(65536 * sizeof(float));
    ASSERT_TRUE(buffer);
    buffer->bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    const auto run = [&] {
        outcome.program->use();
        dispatch({1024, 1, 1});
        finishShaderWrites();
    };
    run();
    fill(1);
    glFinish();
    Timer each = timer();
    each.begin(1);
    run();
    each.end();
    each.begin(2);
    fill(1);
    each.end();
    each.finish();
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_GT(taken[0].second, 2 * taken[1].second) << "the pass after it does not pay for it";
}

TEST_F(TimerTest, APieceContainsThoseWithinIt) {
    fill(200);
    glFinish();
    Timer each = timer();
    each.begin(0);
    for (std::size_t i = 1; i < 4; ++i) {
        each.begin(i);
        fill(200);
        each.end();
    }
    each.end();
    each.end();  // nothing was begun
    each.finish();
    ASSERT_EQ(taken.size(), 4U);
    EXPECT_EQ(taken[3].first, 0U) << "it ends last";
    double within = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(taken[i].first, i + 1);
        within += taken[i].second;
    }
    EXPECT_GE(taken[3].second, within);
}

TEST_F(TimerTest, CollectsWithoutWaiting) {
    Timer each = timer();
    each.begin(7);
    fill(10);
    each.end();
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    while (taken.empty() && Clock::now() - start < std::chrono::seconds(20)) {
        glFlush();
        each.collect();
    }
    ASSERT_EQ(taken.size(), 1U);
    each.finish();
    EXPECT_EQ(taken.size(), 1U) << "each piece is taken once";
}

TEST_F(TimerTest, ManyPiecesAreAllMeasured) {
    Timer each = timer();
    constexpr std::size_t kMany = 3000;
    for (std::size_t i = 0; i < kMany; ++i) {
        each.begin(i);
        each.end();
    }
    EXPECT_GE(taken.size(), kMany - 1024) << "no more queries than that wait";
    each.finish();
    ASSERT_EQ(taken.size(), kMany);
    for (std::size_t i = 0; i < kMany; ++i) ASSERT_EQ(taken[i].first, i);
}

TEST_F(TimerTest, ItsCallsAreNotCounted) {
    fill(1);
    CallCounts with, without;
    {
        const CallCounter counter;
        fill(1);
        without = counter.counts();
    }
    {
        const CallCounter counter;
        Timer each = timer();
        each.begin(0);
        fill(1);
        each.end();
        each.collect();
        each.finish();
        with = counter.counts();
    }
    EXPECT_EQ(with.calls, without.calls);
    EXPECT_EQ(taken.size(), 1U);
}

TEST_F(TimerTest, WithoutATimerNothingIsMeasured) {
    Capabilities none = driver();
    none.timerBits = 0;
    Timer each(none, [](std::size_t, double) { ADD_FAILURE() << "measured"; });
    EXPECT_FALSE(each.measures());
    each.begin(0);
    fill(1);
    each.end();
    each.collect();
    each.finish();
}

}  // namespace
}  // namespace glibra::gpu
