#pragma once
// Compute programs. Everything here needs Capabilities::compute.

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "gpu/object/buffer.h"
#include "gpu/object/program.h"

namespace glibra::gpu {

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
