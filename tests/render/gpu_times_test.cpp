// The GPU time of passes, dispatches and clears.

#include "render/gpu_times.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gpu/context/call_counter.h"
#include "modern_text.h"
#include "render/file/job.h"
#include "skip_runs.h"

namespace glibra::test {
namespace {

using GpuTime = render::Stats::GpuTime;

constexpr const char* kCount = R"(#version 430 core
layout(local_size_x = 4) in;
layout(std430) buffer Sums { float sums[]; };
void main() { sums[gl_GlobalInvocationID.x] += 1.; }
)";
constexpr const char* kGrey = "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(.5); }\n";

/// Draws `scene` and returns "times: what, line" for each entry.
class GpuTimesOf {
  public:
    explicit GpuTimesOf(const std::string& scene, const std::map<std::string, std::string>& files,
                        const RenderOptions& options = {}, const std::vector<double>& moments = {0})
        : folder_(scene, files) {
        render::GpuTimes times(sharedContext().capabilities());
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(sharedContext(), folder_ / "scene.glib", options, stats_);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        if (!loaded) return;
        loaded->measureGpu(times);
        for (const double each : moments) EXPECT_TRUE(loaded->draw(each, stats_));
        measured = times.finish();
    }
    [[nodiscard]] std::vector<std::string> entries() const {
        std::vector<std::string> all;
        for (const GpuTime& each : measured) {
            EXPECT_GE(each.milliseconds, 0);
            all.push_back(std::to_string(each.times) + ": " + each.what + ", " + std::to_string(each.line));
        }
        return all;
    }
    std::vector<GpuTime> measured;

  private:
    SceneFolder folder_;
    render::Stats stats_;
};

class GpuTimesTest : public testing::Test {
  protected:
    void SetUp() override {
        if (sharedContext().capabilities().timerBits == 0) GTEST_SKIP() << "the driver has no timer";
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }
};

const std::string kSteps =
    "WindowSize 8 8\n"
    "Compute count.comp\n"
    "Program Count\n"
    "Fragment fill.frag\n"
    "Program Fill_\n"
    "Texture2D half 4 4 rgba8\n"
    "Buffer Sums float 8\n"
    "Step 10\n"
    "    Dispatch Count 2\n"
    "EndStep\n"
    "Fill half with Fill_\n"
    "Fill window with Fill_\n";

TEST_F(GpuTimesTest, AreThoseOfEachNodeByItsLine) {
    const GpuTimesOf drawn(kSteps, {{"count.comp", kCount}, {"fill.frag", kGrey}}, {.skip = false},
                           {0, .5, 1});
    EXPECT_EQ(drawn.entries(), (std::vector<std::string>{"3: pass into half, 11", "3: pass into window, 12",
                                                         "10: dispatch of Count, 9"}))
        << drawn.measured.size();
}

TEST_F(GpuTimesTest, ContainEveryTile) {
    RenderOptions options;
    options.tileSize = 4;
    const GpuTimesOf drawn("WindowSize 8 8\nFragment fill.frag\nProgram P\nFill window with P\n",
                           {{"fill.frag", kGrey}}, options);
    EXPECT_EQ(drawn.entries(), (std::vector<std::string>{"4: pass into window, 4"}));
}

TEST_F(GpuTimesTest, NameTheMeansOfSamples) {
    RenderOptions options;
    options.samples = 4;
    const GpuTimesOf drawn("WindowSize 8 8\nFragment fill.frag\nProgram P\nFill window with P\n",
                           {{"fill.frag", kGrey}}, options);
    EXPECT_EQ(drawn.entries(),
              (std::vector<std::string>{"1: pass into window, 4", "1: means of the window's samples, 0"}));
}

TEST_F(GpuTimesTest, DoNotChangeThePictureOrTheCalls) {
    const SceneFolder folder(kSteps, {{"count.comp", kCount}, {"fill.frag", kGrey}});
    const auto draw = [&](bool isMeasured) {
        render::GpuTimes times(sharedContext().capabilities());
        render::Stats stats;
        const gpu::CallCounter counter;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(sharedContext(), folder / "scene.glib", {}, stats);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        if (isMeasured) loaded->measureGpu(times);
        std::vector<std::byte> pixels = loaded->draw(1, stats)->data;
        times.finish();
        return std::pair(std::move(pixels), counter.counts().calls);
    };
    draw(false);
    EXPECT_TRUE(draw(true) == draw(false));
}

TEST_F(GpuTimesTest, AreInTheExplanationAndTheFigures) {
    const SceneFolder folder(kSteps, {{"count.comp", kCount}, {"fill.frag", kGrey}});
    render::Job job;
    job.scene = folder / "scene.glib";
    job.output = folder / "out.png";
    job.frames = 3;
    job.framesPerSecond = 2;
    job.explain = job.stats = true;
    job.options.skip = false;
    const render::JobResult result = render::runJob(sharedContext(), job, [](int) {});
    EXPECT_FALSE(result.failed) << text(result.diagnostics);
    EXPECT_NE(result.explanation.find("GPU time\n"), std::string::npos);
    EXPECT_NE(result.explanation.find("ms  dispatch of Count, line 9 (10 times)\n"), std::string::npos)
        << result.explanation;
    const auto json = nlohmann::json::parse(result.statsJson);
    ASSERT_EQ(json["gpuTime"].size(), 3U);
    EXPECT_EQ(json["gpuTime"][0]["what"], "pass into half");
    EXPECT_EQ(json["gpuTime"][0]["line"], 11);
    EXPECT_EQ(json["gpuTime"][0]["times"], 3);
    EXPECT_GE(json["gpuTime"][0]["milliseconds"].get<double>(), 0);
}

TEST(GpuTimesText, SaysThatNothingIsMeasured) {
    render::Stats stats;
    EXPECT_NE(render::toText(stats).find("GPU time: not measured"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::parse(render::toJson(stats, "s", 1, 1, "d"))["gpuTime"].is_null());
    stats.gpu.emplace();
    stats.gpu->push_back({"pass into window", 4, 1, 2.5});
    stats.gpu->push_back({"dispatch of Move", 9, 60, 10});
    EXPECT_NE(render::toText(stats).find("GPU time\n"
                                         "       2.50 ms  pass into window, line 4\n"
                                         "      10.00 ms  dispatch of Move, line 9 (60 times)\n"
                                         "      12.50 ms  together\n"),
              std::string::npos)
        << render::toText(stats);
}

}  // namespace
}  // namespace glibra::test
