#pragma once
// Drawing without a scene: programs from source texts, uniforms by name, a rectangle over the whole target,
// and pixels and captured vertices as floats. Targets are gpu::Target::window. The bench's context must be
// current.

#include <glibra/result.h>

#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/framebuffer.h"
#include "gpu/object/program.h"
#include "gpu/object/vertex_array.h"

namespace glibra::bench {

/// A vertex shader that covers the target with one triangle and writes `out vec2 vPlace`: (0, 0) at the lower
/// left corner of the target, (1, 1) at the upper right one.
extern const std::string_view kWholeTarget;

/// A program of these stages. Each source without a #version gets `#version 410 core` as its first line.
/// `captured` names the outputs of the last stage before rasterisation that capture() reads. gpu-E02 with the
/// driver's log if it does not build.
Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::span<const gpu::StageSource> stages,
                             std::vector<std::string> captured = {});
Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::string_view vertex,
                             std::string_view fragment);

/// Sets a uniform by its name and makes the program current: a float, a vector of 2 to 4 components, or 16
/// floats (a mat4, column by column). Names that are not active are ignored.
void setFloats(const gpu::Program& program, const char* name, std::initializer_list<float> values);
void setFloats(const gpu::Program& program, const char* name, std::span<const float> values);
/// Sets a vec3 of rounded components.
void setVector(const gpu::Program& program, const char* name, const glm::dvec3& value);
/// Sets an int, or the texture unit of a sampler.
void setInt(const gpu::Program& program, const char* name, int value);

/// Draws `count` vertices without buffers; the vertex shader works from gl_VertexID.
void drawVertices(const gpu::Program& program, GLenum primitive, int count);
/// Draws a program with kWholeTarget over the bound target.
void drawWhole(const gpu::Program& program);

/// The first colour of the target after resolving its samples: `components` (1 to 4) floats per pixel, rows
/// from top to bottom. Waits for the drawing. Byte formats give 0..1.
Result<std::vector<float>> readFloats(const gpu::Capabilities& capabilities, const gpu::Target& target,
                                      int components = 4);

/// The captured outputs of a draw.
struct Captured {
    std::vector<float> values;  ///< vertex after vertex; the outputs of each in the order of their names
    int primitives = 0;
};

/// Draws `count` vertices without buffers and without rasterising, and returns the captured outputs of the
/// program, `floatsPerVertex` each. `captures` is the primitive in the buffer: GL_POINTS, GL_LINES or
/// GL_TRIANGLES. The buffer has room for `mostVertices`; further vertices are lost (gpu-E03). `primitive`:
/// GL_PATCHES, GL_POINTS and so on.
Result<Captured> capture(const gpu::Capabilities& capabilities, const gpu::Program& program, GLenum primitive,
                         int count, GLenum captures, int floatsPerVertex, int mostVertices);

}  // namespace glibra::bench
