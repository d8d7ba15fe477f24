#pragma once
// Builds a linked program from shader sources, in two steps, so that a driver with its own compiler threads
// can build several at once.

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/buffer.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

/// A linked program.
class Program {
  public:
    explicit Program(GLuint linked) : name_(linked) {}
    void use() const { glUseProgram(name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }
    /// Notes the bytes that are about to be uploaded to `count` elements of a uniform, from that location on.
    /// False if the last upload was the same, so that it need not be repeated.
    bool willHold(GLint location, int count, std::span<const std::byte> bytes) const;
    /// Invocations per group along x, y and z, as the compute stage declares them; the driver is asked once.
    [[nodiscard]] const std::array<int, 3>& localSize() const;

  private:
    Name<glDeleteProgram> name_;
    mutable std::map<GLint, std::vector<std::byte>> uploaded_;  ///< by location, one element each
    mutable std::optional<std::array<int, 3>> localSize_;
};

/// One stage, GL_VERTEX_SHADER ..., and its complete text.
struct StageSource {
    GLenum stage = GL_VERTEX_SHADER;
    std::string_view text;
};

/// The name of a vertex input or fragment output and its location, unless the shader states one.
struct NamedLocation {
    std::string name;
    GLuint location = 0;
};

struct ProgramSource {
    std::span<const StageSource> stages{};
    std::vector<NamedLocation> vertexInputs{};
    std::vector<NamedLocation> fragmentOutputs{};
    std::vector<std::string> captured{};  ///< outputs that transform feedback writes, interleaved
    bool separable = false;
};

/// The driver's log of one stage. A log without an error contains warnings.
struct StageLog {
    GLenum stage = GL_VERTEX_SHADER;
    bool compiled = false;
    std::string log;
};

struct BuildOutcome {
    std::optional<Program> program;  ///< nothing if a stage did not compile or they did not link
    std::vector<StageLog> stages;    ///< in the order given
    std::string linkLog;             ///< empty if a stage did not compile
};

/// A program being built: compiling and linking are requested, and nothing has waited for them.
class ProgramBuild {
  public:
    ProgramBuild(const Capabilities& capabilities, const ProgramSource& source);
    /// True if finish() will not wait. Always true without GL_KHR_parallel_shader_compile.
    [[nodiscard]] bool isReady() const;
    /// Waits for the build and returns its outcome. Call it once.
    BuildOutcome finish();

  private:
    struct StageBuild {
        GLenum stage;
        Name<glDeleteShader> shader;
    };
    std::vector<StageBuild> stages_;
    Name<glDeleteProgram> program_;
    bool canAsk_ = false;
};

/// Does both steps.
BuildOutcome buildProgram(const Capabilities& capabilities, const ProgramSource& source);

// Compute programs. Everything here needs Capabilities::compute.

/// The groups that give at least that many invocations: each count divided by Program::localSize(), rounded
/// up.
std::array<std::uint64_t, 3> groupsOver(const std::array<std::uint64_t, 3>& invocations,
                                        const std::array<int, 3>& localSize);

/// Runs the program in use with that many groups, each at most Capabilities::maxComputeGroups. Nothing runs
/// if one is 0.
void dispatch(const std::array<GLuint, 3>& groups);
/// Runs it with the three group counts that the buffer holds at `offset`, a multiple of 4.
void dispatchFrom(const Buffer& groups, std::size_t offset = 0);

/// What shaders have written so far is visible to everything after it.
inline void finishShaderWrites() {
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace glibra::gpu
