#include "bench/draw/offscreen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "gpu/context/errors.h"
#include "gpu/object/buffer.h"
#include "gpu/object/readback.h"
#include "gpu/object/timer.h"

namespace glibra::bench {
namespace {

constexpr std::string_view kVersion = "#version 410 core\n";

std::string logOf(const gpu::BuildOutcome& outcome) {
    std::string log;
    for (const gpu::StageLog& stage : outcome.stages)
        if (!stage.compiled) log += stage.log;
    return log + outcome.linkLog;
}

int verticesEach(GLenum captures) {
    return captures == GL_TRIANGLES ? 3 : captures == GL_LINES ? 2 : 1;
}

}  // namespace

const std::string_view kWholeTarget =
    "out vec2 vPlace;\n"
    "void main() {\n"
    "    vPlace = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.;\n"
    "    gl_Position = vec4(vPlace * 2. - 1., 0., 1.);\n"
    "}\n";

Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::span<const gpu::StageSource> stages,
                             std::vector<std::string> captured) {
    std::vector<std::string> texts;
    for (const gpu::StageSource& stage : stages)
        texts.push_back(stage.text.find("#version") == std::string_view::npos
                            ? std::string(kVersion) + std::string(stage.text)
                            : std::string(stage.text));
    std::vector<gpu::StageSource> sources;
    for (std::size_t i = 0; i < texts.size(); ++i) sources.push_back({stages[i].stage, texts[i]});
    gpu::BuildOutcome outcome =
        gpu::buildProgram(capabilities, {.stages = sources, .captured = std::move(captured)});
    if (!outcome.program)
        return diagnose("gpu-E02", fmt::format("the driver rejects a shader program of the benchmarks: {}",
                                               logOf(outcome)));
    return std::move(*outcome.program);
}

Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::string_view vertex,
                             std::string_view fragment) {
    const std::vector<gpu::StageSource> stages{{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}};
    return program(capabilities, stages);
}

void setFloats(const gpu::Program& program, const char* name, std::span<const float> values) {
    program.use();
    const GLint location = glGetUniformLocation(program.id(), name);
    switch (values.size()) {
        case 1:
            return glUniform1fv(location, 1, values.data());
        case 2:
            return glUniform2fv(location, 1, values.data());
        case 3:
            return glUniform3fv(location, 1, values.data());
        case 4:
            return glUniform4fv(location, 1, values.data());
        case 16:
            return glUniformMatrix4fv(location, 1, GL_FALSE, values.data());
        default:
            break;
    }
}

void setFloats(const gpu::Program& program, const char* name, std::initializer_list<float> values) {
    setFloats(program, name, std::span(values.begin(), values.size()));
}

void setVector(const gpu::Program& program, const char* name, const glm::dvec3& value) {
    const glm::vec3 rounded(value);
    setFloats(program, name, {rounded.x, rounded.y, rounded.z});
}

void setInt(const gpu::Program& program, const char* name, int value) {
    program.use();
    glUniform1i(glGetUniformLocation(program.id(), name), value);
}

void drawVertices(const gpu::Program& program, GLenum primitive, int count) {
    const gpu::VertexArray none{{}};
    program.use();
    none.bind();
    glDrawArrays(primitive, 0, count);
}

void drawWhole(const gpu::Program& program) {
    drawVertices(program, GL_TRIANGLES, 3);
}

Result<std::vector<float>> readFloats(const gpu::Capabilities& capabilities, const gpu::Target& target,
                                      int components) {
    target.resolve();
    Result<std::vector<std::byte>> bytes =
        gpu::readPixels(capabilities, target.readable(), 0, {0, 0, target.width(), target.height()},
                        {components, gpu::TexelType::f32});
    if (!bytes) return std::move(bytes.diagnostics);
    std::vector<float> values(bytes->size() / sizeof(float));
    std::memcpy(values.data(), bytes->data(), bytes->size());
    return values;
}

Result<Captured> capture(const gpu::Capabilities& capabilities, const gpu::Program& program, GLenum primitive,
                         int count, GLenum captures, int floatsPerVertex, int mostVertices) {
    // Nothing is rasterised, but drawing without any target is an error.
    Result<gpu::Target> target = gpu::Target::window(capabilities, 1, 1, gpu::TexelFormat::rgba8);
    if (!target) return std::move(target.diagnostics);
    target->bind();
    const std::size_t vertexBytes = static_cast<std::size_t>(floatsPerVertex) * sizeof(float);
    Result<gpu::Buffer> buffer =
        gpu::Buffer::create(vertexBytes * static_cast<std::size_t>(mostVertices), GL_STREAM_READ);
    if (!buffer) return std::move(buffer.diagnostics);
    const gpu::Query made(GL_PRIMITIVES_GENERATED), written(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);

    gpu::clearErrors();
    const gpu::VertexArray none{{}};
    none.bind();
    program.use();  // before the feedback starts, which forbids it
    buffer->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
    glEnable(GL_RASTERIZER_DISCARD);
    made.begin();
    written.begin();
    glBeginTransformFeedback(captures);
    glDrawArrays(primitive, 0, count);
    glEndTransformFeedback();
    written.end();
    made.end();
    glDisable(GL_RASTERIZER_DISCARD);
    const std::uint64_t generated = made.result(), kept = written.result();

    Captured result;
    result.primitives = static_cast<int>(kept);
    result.values.resize(static_cast<std::size_t>(kept) * static_cast<std::size_t>(verticesEach(captures)) *
                         static_cast<std::size_t>(floatsPerVertex));
    buffer->bind(GL_TRANSFORM_FEEDBACK_BUFFER);
    if (!result.values.empty())
        glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                           static_cast<GLsizeiptr>(result.values.size() * sizeof(float)),
                           result.values.data());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    if (const GLenum code = gpu::takeError(); code != GL_NO_ERROR)
        return gpu::allocationError(code, "capturing vertices");
    if (generated != kept)
        return diagnose("gpu-E03", fmt::format("{} primitives were drawn, but the buffer has room for {}",
                                               generated, kept));
    return result;
}

}  // namespace glibra::bench
