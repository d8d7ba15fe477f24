#include "bench/core/device.h"

#include <gtest/gtest.h>

#include <array>

namespace glibra::bench {
namespace {

class Device : public testing::Test {
  protected:
    Bench bench{BenchOptions{.quick = true}};
};

TEST_F(Device, PlaceRunsFromTheLowerLeftAndRowsFromTheTop) {
    const Canvas canvas(bench, 8, 4, gpu::TexelFormat::rgba32f);
    const Shader ramp(bench,
                      "in vec2 vPlace; uniform vec2 uScale; out vec4 fColor;"
                      "void main() { fColor = vec4(vPlace * uScale, 3., 4.); }");
    canvas.bind();
    ramp.set("uScale", glm::vec2(1, 2)).draw();
    const std::vector<float> pixels = canvas.pixels();
    ASSERT_EQ(pixels.size(), 8U * 4U * 4U);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 8; ++column) {
            const float* pixel = pixels.data() + (row * 8 + column) * 4;
            EXPECT_FLOAT_EQ(pixel[0], (static_cast<float>(column) + .5F) / 8);
            EXPECT_FLOAT_EQ(pixel[1], 2 * (static_cast<float>(3 - row) + .5F) / 4);
            EXPECT_EQ(pixel[2], 3);
            EXPECT_EQ(pixel[3], 4);
        }
}

TEST_F(Device, CaptureGivesTheOutputsVertexByVertex) {
    const Shader counting(
        bench,
        std::array{gpu::StageSource{
            GL_VERTEX_SHADER,
            "out float vTwice; out vec2 vSquares;"
            "void main() { float i = float(gl_VertexID); vTwice = 2. * i; vSquares = vec2(i * i, 1.); }"}},
        {"vTwice", "vSquares"});
    const Captured captured = counting.capture(GL_POINTS, 5, GL_POINTS, 3, 5);
    EXPECT_EQ(captured.primitives, 5);
    EXPECT_EQ(captured.values, (std::vector<float>{0, 0, 1, 2, 1, 1, 4, 4, 1, 6, 9, 1, 8, 16, 1}));
    EXPECT_THROW((void)counting.capture(GL_POINTS, 5, GL_POINTS, 3, 4), Failed);
}

TEST_F(Device, AProgramThatDoesNotCompileIsAnErrorWithTheDriversLog) {
    bench.attempt([&] { Shader(bench, "void main() { missing = 1.; }"); });
    ASSERT_FALSE(bench.problems().empty());
    EXPECT_EQ(bench.problems().front().id, "gpu-E02");
    EXPECT_NE(bench.problems().front().text.find("missing"), std::string::npos);
}

TEST_F(Device, AMessageIsReportedOnce) {
    for (int i = 0; i < 2; ++i) bench.attempt([] { throw Failed({diagnose("gpu-E01", "no driver")}); });
    EXPECT_EQ(bench.problems().size(), 1U);
}

}  // namespace
}  // namespace glibra::bench
