#include "fixture.h"

#include "gpu/object/buffer.h"

namespace glibra::gpu::test {

std::unique_ptr<Context> GpuTest::opened;

const char* const kCoverAll = R"(#version 410 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0, 1);
}
)";

std::string text(const Diagnostics& diagnostics) {
    std::string lines;
    for (const Diagnostic& each : diagnostics) lines += toString(each) + "\n";
    return lines;
}

std::vector<Rgba> pixels(const Context& context, const Target& target, int index) {
    std::vector<Rgba> result(static_cast<std::size_t>(target.width()) *
                             static_cast<std::size_t>(target.height()));
    const Diagnostics problems =
        readPixels(context.capabilities(), target.readable(), index, {0, 0, target.width(), target.height()},
                   {4, TexelType::f32}, std::as_writable_bytes(std::span(result)));
    EXPECT_TRUE(problems.empty()) << text(problems);
    return result;
}

void GpuTest::SetUpTestSuite() {
    auto made = openContext();
    ASSERT_TRUE(made) << text(made.diagnostics);
    opened = std::make_unique<Context>(std::move(*made));
}

void GpuTest::TearDownTestSuite() {
    opened.reset();
}

void GpuTest::SetUp() {
    ASSERT_TRUE(opened) << "no OpenGL driver";
}

void GpuTest::TearDown() {
    if (!opened) return;
    opened->debugLog().check("the test");
    const Diagnostics left = opened->debugLog().takeDiagnostics();
    EXPECT_TRUE(left.empty()) << text(left);
}

std::optional<Program> GpuTest::build(std::string_view vertex, std::string_view fragment) {
    const std::array<StageSource, 2> stages{{{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}};
    BuildOutcome outcome = buildProgram(driver(), {.stages = stages});
    std::string logs = outcome.linkLog;
    for (const StageLog& each : outcome.stages) logs += each.log;
    EXPECT_TRUE(outcome.program) << logs;
    return std::move(outcome.program);
}

std::vector<Rgba> GpuTest::shade(const Program& program, int width, int height) {
    auto target = Target::window(driver(), width, height, TexelFormat::rgba32f);
    EXPECT_TRUE(target) << text(target.diagnostics);
    if (!target) return {};
    const VertexArray nothing({});
    target->bind();
    target->clearColor(0, {-1, -1, -1, -1});
    nothing.bind();
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return pixels(context(), *target);
}

}  // namespace glibra::gpu::test
