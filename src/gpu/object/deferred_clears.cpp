#include "gpu/object/deferred_clears.h"

#include <glad/gl.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "gpu/object/compute.h"

namespace glibra::gpu {
namespace {

constexpr std::size_t kWord = 16;    ///< bytes of an element
constexpr std::size_t kGroup = 256;  ///< invocations
constexpr const char* kClearing = R"(#version 430 core
layout(local_size_x = 256) in;
layout(std430, binding = 0) writeonly buffer Words { uvec4 words[]; };
void main() {
    uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 256u + gl_LocalInvocationID.x;
    if (i < uint(words.length())) words[i] = uvec4(0u);
}
)";

/// Puts back the program in use and the first storage buffer, unless they had been deleted and lived only as
/// long as they were bound.
class ComputeState {
  public:
    ComputeState() {
        glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
        glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &generic_);
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &first_);
    }
    ComputeState(const ComputeState&) = delete;
    ComputeState& operator=(const ComputeState&) = delete;
    ~ComputeState() {
        const auto name = [](GLint kept, auto exists) {
            return exists(static_cast<GLuint>(kept)) == GL_TRUE ? static_cast<GLuint>(kept) : 0U;
        };
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, name(first_, glIsBuffer));
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, name(generic_, glIsBuffer));
        glUseProgram(name(program_, glIsProgram));
    }

  private:
    GLint program_ = 0, generic_ = 0, first_ = 0;
};

}  // namespace

void BufferClearer::clear(const Capabilities& capabilities, Buffer& buffer) {
    if (capabilities.isSoftware || buffer.size() < kLarge || !clearByShader(capabilities, buffer))
        buffer.clear(capabilities);
}

bool BufferClearer::clearByShader(const Capabilities& capabilities, Buffer& buffer) {
    const std::uint64_t words = buffer.size() / kWord;
    if (!capabilities.compute || std::cmp_greater(buffer.size(), capabilities.maxStorageBlockBytes))
        return false;
    if (!program_) {
        const std::array<StageSource, 1> stages{{{GL_COMPUTE_SHADER, kClearing}}};
        program_ = ProgramBuild(capabilities, {.stages = stages}).finish().program;
        if (!program_) return false;
    }
    const std::uint64_t groups = (words + kGroup - 1) / kGroup;
    const std::uint64_t columns =
        std::min<std::uint64_t>(groups, static_cast<std::uint64_t>(capabilities.maxComputeGroups[0]));
    const std::uint64_t rows = columns == 0 ? 0 : (groups + columns - 1) / columns;
    const ComputeState state;
    finishShaderWrites();
    program_->use();
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    dispatch({static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1});
    finishShaderWrites();
    const std::array<std::byte, kWord> zeros{};
    buffer.update(words * kWord, std::span(zeros).first(buffer.size() - words * kWord));
    return true;
}

}  // namespace glibra::gpu
