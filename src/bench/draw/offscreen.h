#pragma once
// Drawing without a scene: a program from texts, uniforms by name, a rectangle over the whole target, pixels
// and captured vertices as floats. Targets are gpu::Target::window. The bench's context must be current.

#include <glibra/result.h>

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/capabilities.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "gpu/vertex_array.h"

namespace glibra::bench {

/// A vertex shader that covers the target with one triangle and gives `out vec2 vPlace`: (0, 0) at the lower
/// left corner of the target, (1, 1) at the upper right one.
extern const std::string_view kWholeTarget;

/// A program of these stages; each text gets the line `#version 410 core` before its first, unless it has a
/// #version of its own. `captured` names the outputs of the last stage before rasterisation that capture()
/// reads. gpu-E02 with the driver's log if it does not build.
Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::span<const gpu::StageSource> stages,
                             std::vector<std::string> captured = {});
Result<gpu::Program> program(const gpu::Capabilities& capabilities, std::string_view vertex,
                             std::string_view fragment);

/// Sets a uniform of the program by its name and makes the program the one in use: a float or a vector of 2
/// to 4 components, or 16 (a mat4, column by column). A name that is not active is passed over.
void setFloats(const gpu::Program& program, const char* name, std::initializer_list<float> values);
void setFloats(const gpu::Program& program, const char* name, std::span<const float> values);
/// An int, or the texture unit of a sampler.
void setInt(const gpu::Program& program, const char* name, int value);

/// Draws `count` vertices that no buffer feeds; the vertex shader works from gl_VertexID.
void drawVertices(const gpu::Program& program, GLenum primitive, int count);
/// Draws a program with kWholeTarget over the bound target.
void drawWhole(const gpu::Program& program);

/// The target's first colour after resolving its samples: `components` (1 to 4) floats a pixel, rows from top
/// to bottom. Waits for the drawing. Byte formats give 0..1.
Result<std::vector<float>> readFloats(const gpu::Capabilities& capabilities, const gpu::Target& target,
                                      int components = 4);

/// What a drawing wrote to its program's captured outputs.
struct Captured {
    std::vector<float> values;  ///< vertex after vertex, the outputs of each in the order of their names
    int primitives = 0;
};

/// Draws `count` vertices without buffers and without rasterising, and gives what the program's captured
/// outputs were, `floatsPerVertex` each. `captures` is what reaches the buffer: GL_POINTS, GL_LINES or
/// GL_TRIANGLES; room is made for `mostVertices`, and what goes beyond is lost (gpu-E03). `primitive`:
/// GL_PATCHES, GL_POINTS and so on.
Result<Captured> capture(const gpu::Capabilities& capabilities, const gpu::Program& program, GLenum primitive,
                         int count, GLenum captures, int floatsPerVertex, int mostVertices);

}  // namespace glibra::bench
