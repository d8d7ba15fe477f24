#pragma once
// OpenGL ES fills triangles only. Where a scene draws their edges, these are lines of their own.

#include <glad/gl.h>

#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "gpu/object/buffer.h"

namespace glibra::gpu {

/// The edges of triangles, or the lines, two indices each. `mode`: GL_TRIANGLES, GL_TRIANGLE_STRIP,
/// GL_TRIANGLE_FAN, GL_LINES, GL_LINE_STRIP or GL_LINE_LOOP; the largest index begins anew.
std::vector<std::uint32_t> edgesOf(std::span<const std::uint32_t> indices, GLenum mode);

class EdgeBuffers {
  public:
    /// Draws the edges of triangles with the vertex array that is bound. `indices`: its buffer of indices, of
    /// which it draws `count` from the byte `offset` on; null: the first `count` vertices.
    void draw(const Buffer* indices, std::size_t offset, int count, GLenum mode, int instances);

  private:
    struct Edges {
        Buffer buffer;
        int count = 0;
        std::uint64_t content = 0;  ///< of the indices
    };
    using Key = std::tuple<GLuint, std::size_t, std::uint32_t, GLenum>;
    std::map<Key, Edges> made_;
};

}  // namespace glibra::gpu
