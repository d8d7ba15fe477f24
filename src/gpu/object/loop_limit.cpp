#include "gpu/object/loop_limit.h"

#include <array>
#include <cstring>

#include "gpu/object/buffer.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/readback.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {
namespace {

constexpr int kLoopRounds = 1 << 20;  // a float holds every count up to here
constexpr const char* kVertex =
    "#version 410 core\nvoid main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4. - 1., "
    "0., 1.); "
    "}\n";
// The step is a uniform, so that no compiler can compute the sum.
constexpr const char* kFragment =
    "#version 410 core\nuniform int uRounds, uStep;\nout vec4 fColor;\nvoid main() {\n"
    "    int count = 0;\n    for (int i = 0; i < uRounds; i += uStep) count += uStep;\n"
    "    fColor = vec4(count);\n}\n";

}  // namespace

int measureLoopLimit(const Context& context) {
    const Capabilities& driver = context.capabilities();
    const std::array<StageSource, 2> stages{{{GL_VERTEX_SHADER, kVertex}, {GL_FRAGMENT_SHADER, kFragment}}};
    const BuildOutcome built = buildProgram(driver, {.stages = stages});
    const Result<Target> target = Target::window(driver, 1, 1, TexelFormat::r32f);
    if (!built.program || !target) return 0;
    target->bind();
    target->clearDepth();
    built.program->use();
    glUniform1i(glGetUniformLocation(built.program->id(), "uRounds"), kLoopRounds);
    glUniform1i(glGetUniformLocation(built.program->id(), "uStep"), 1);
    const VertexArray nothing{{}};
    nothing.bind();
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    float count = 0;
    const auto bytes = readPixels(driver, target->readable(), 0, {0, 0, 1, 1}, {1, TexelType::f32});
    if (!bytes || bytes->size() != sizeof count) return 0;
    std::memcpy(&count, bytes->data(), sizeof count);
    return count < kLoopRounds ? static_cast<int>(count) : 0;
}

}  // namespace glibra::gpu
