#include "bench/draw/offscreen.h"

#include <gtest/gtest.h>

#include "bench/core/bench.h"

namespace glibra::bench {
namespace {

class Offscreen : public testing::Test {
  protected:
    void SetUp() override {
        Result<gpu::Context*> opened = bench.context();
        ASSERT_TRUE(opened) << toString(opened.diagnostics.front());
        context = *opened;
    }
    [[nodiscard]] const gpu::Capabilities& capabilities() const { return context->capabilities(); }

    Bench bench{BenchOptions{.quick = true}};
    gpu::Context* context = nullptr;
};

TEST_F(Offscreen, PlaceRunsFromTheLowerLeftAndRowsFromTheTop) {
    Result<gpu::Target> target = gpu::Target::window(capabilities(), 8, 4, gpu::TexelFormat::rgba32f);
    ASSERT_TRUE(target);
    Result<gpu::Program> ramp = program(capabilities(), kWholeTarget,
                                        "in vec2 vPlace; uniform vec2 uScale; out vec4 fColor;"
                                        "void main() { fColor = vec4(vPlace * uScale, 3., 4.); }");
    ASSERT_TRUE(ramp) << toString(ramp.diagnostics.front());
    target->bind();
    setFloats(*ramp, "uScale", {1.F, 2.F});
    drawWhole(*ramp);
    Result<std::vector<float>> pixels = readFloats(capabilities(), *target);
    ASSERT_TRUE(pixels);
    ASSERT_EQ(pixels->size(), 8U * 4U * 4U);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 8; ++column) {
            const float* pixel = pixels->data() + (row * 8 + column) * 4;
            EXPECT_FLOAT_EQ(pixel[0], (static_cast<float>(column) + .5F) / 8);
            EXPECT_FLOAT_EQ(pixel[1], 2 * (static_cast<float>(3 - row) + .5F) / 4);
            EXPECT_EQ(pixel[2], 3);
            EXPECT_EQ(pixel[3], 4);
        }
}

TEST_F(Offscreen, CaptureGivesTheOutputsVertexByVertex) {
    const std::vector<gpu::StageSource> stages{
        {GL_VERTEX_SHADER,
         "out float vTwice; out vec2 vSquares;"
         "void main() { float i = float(gl_VertexID); vTwice = 2. * i; vSquares = vec2(i * i, 1.); }"}};
    Result<gpu::Program> counting = program(capabilities(), stages, {"vTwice", "vSquares"});
    ASSERT_TRUE(counting) << toString(counting.diagnostics.front());
    Result<Captured> captured = capture(capabilities(), *counting, GL_POINTS, 5, GL_POINTS, 3, 5);
    ASSERT_TRUE(captured) << toString(captured.diagnostics.front());
    EXPECT_EQ(captured->primitives, 5);
    EXPECT_EQ(captured->values, (std::vector<float>{0, 0, 1, 2, 1, 1, 4, 4, 1, 6, 9, 1, 8, 16, 1}));
    const Result<Captured> tooSmall = capture(capabilities(), *counting, GL_POINTS, 5, GL_POINTS, 3, 4);
    EXPECT_FALSE(tooSmall);
}

TEST_F(Offscreen, AProgramThatDoesNotCompileIsAnErrorWithTheDriversLog) {
    Result<gpu::Program> wrong = program(capabilities(), kWholeTarget, "void main() { missing = 1.; }");
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.diagnostics.front().id, "gpu-E02");
    EXPECT_NE(wrong.diagnostics.front().text.find("missing"), std::string::npos);
}

}  // namespace
}  // namespace glibra::bench
