#include "gpu/object/program.h"

#include <algorithm>

namespace glibra::gpu {
namespace {

/// The log of a shader or program, by the functions of GL for its kind.
std::string logOf(GLuint name, PFNGLGETSHADERIVPROC query, PFNGLGETSHADERINFOLOGPROC read) {
    GLint length = 0;
    query(name, GL_INFO_LOG_LENGTH, &length);
    if (length <= 1) return {};
    std::string log(static_cast<std::size_t>(length), '\0');
    GLsizei written = 0;
    read(name, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

}  // namespace

bool Program::willHold(GLint location, int count, std::span<const std::byte> bytes) const {
    if (count <= 0) return false;
    const std::size_t size = bytes.size() / static_cast<std::size_t>(count);
    bool isNew = false;
    for (int i = 0; i < count; ++i) {
        const auto element = bytes.subspan(static_cast<std::size_t>(i) * size, size);
        std::vector<std::byte>& held = uploaded_[location + i];
        if (std::equal(element.begin(), element.end(), held.begin(), held.end())) continue;
        held.assign(element.begin(), element.end());
        isNew = true;
    }
    return isNew;
}

ProgramBuild::ProgramBuild(const Capabilities& capabilities, const ProgramSource& source)
    : program_(glCreateProgram()), canAsk_(capabilities.parallelCompile) {
    // Request everything before querying anything: a query waits. A stage that does not compile only makes
    // the link fail.
    for (const StageSource& each : source.stages) {
        Name<glDeleteShader> shader(glCreateShader(each.stage));
        // An empty view may hold a null pointer, which GL refuses even with length 0.
        const std::array<const GLchar*, 1> texts{each.text.empty() ? "" : each.text.data()};
        const std::array<GLint, 1> lengths{static_cast<GLint>(each.text.size())};
        glShaderSource(shader.get(), 1, texts.data(), lengths.data());
        glCompileShader(shader.get());
        glAttachShader(program_.get(), shader.get());
        stages_.push_back({each.stage, std::move(shader)});
    }
    for (const NamedLocation& each : source.vertexInputs)
        glBindAttribLocation(program_.get(), each.location, each.name.c_str());
    for (const NamedLocation& each : source.fragmentOutputs)
        glBindFragDataLocation(program_.get(), each.location, each.name.c_str());
    if (!source.captured.empty()) {
        std::vector<const GLchar*> names;
        for (const std::string& each : source.captured) names.push_back(each.c_str());
        glTransformFeedbackVaryings(program_.get(), static_cast<GLsizei>(names.size()), names.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    }
    if (source.separable) glProgramParameteri(program_.get(), GL_PROGRAM_SEPARABLE, GL_TRUE);
    glLinkProgram(program_.get());
}

const std::array<int, 3>& Program::localSize() const {
    if (!localSize_) {
        std::array<GLint, 3> size{1, 1, 1};
        glGetProgramiv(id(), GL_COMPUTE_WORK_GROUP_SIZE, size.data());
        localSize_ = size;
    }
    return *localSize_;
}

bool ProgramBuild::isReady() const {
    if (!canAsk_) return true;
    GLint done = GL_TRUE;
    glGetProgramiv(program_.get(), GL_COMPLETION_STATUS_KHR, &done);
    return done != GL_FALSE;
}

BuildOutcome ProgramBuild::finish() {
    BuildOutcome outcome;
    bool allCompiled = true;
    for (const StageBuild& each : stages_) {
        GLint compiled = GL_FALSE;
        glGetShaderiv(each.shader.get(), GL_COMPILE_STATUS, &compiled);
        outcome.stages.push_back(
            {each.stage, compiled != GL_FALSE, logOf(each.shader.get(), glGetShaderiv, glGetShaderInfoLog)});
        allCompiled = allCompiled && compiled != GL_FALSE;
    }
    if (!allCompiled) return outcome;
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.get(), GL_LINK_STATUS, &linked);
    outcome.linkLog = logOf(program_.get(), glGetProgramiv, glGetProgramInfoLog);
    // The linked program no longer needs its shaders.
    for (const StageBuild& each : stages_) glDetachShader(program_.get(), each.shader.get());
    stages_.clear();
    if (linked != GL_FALSE) outcome.program.emplace(program_.release());
    return outcome;
}

BuildOutcome buildProgram(const Capabilities& capabilities, const ProgramSource& source) {
    return ProgramBuild(capabilities, source).finish();
}

std::array<std::uint64_t, 3> groupsOver(const std::array<std::uint64_t, 3>& invocations,
                                        const std::array<int, 3>& localSize) {
    std::array<std::uint64_t, 3> groups{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto size = static_cast<std::uint64_t>(std::max(1, localSize[axis]));
        groups[axis] = invocations[axis] / size + (invocations[axis] % size != 0 ? 1 : 0);
    }
    return groups;
}

void dispatch(const std::array<GLuint, 3>& groups) {
    glDispatchCompute(groups[0], groups[1], groups[2]);
}

void dispatchFrom(const Buffer& groups, std::size_t offset) {
    groups.bind(GL_DISPATCH_INDIRECT_BUFFER);
    glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

}  // namespace glibra::gpu
