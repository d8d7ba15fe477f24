#pragma once
// Buffers, and vertex arrays that read them.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "base/program_resources.h"
#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

/// Device memory for vertices, indices, uniform and storage blocks, atomic counters and the arguments of
/// indirect draws and dispatches. Its size never changes.
class Buffer {
  public:
    /// `usage` is GL_STATIC_DRAW, GL_DYNAMIC_DRAW ... Reports draw-E05 if the device has no memory for it.
    static Result<Buffer> create(std::span<const std::byte> content, GLenum usage = GL_STATIC_DRAW);
    /// The content is undefined.
    static Result<Buffer> create(std::size_t bytes, GLenum usage = GL_DYNAMIC_DRAW);

    /// Overwrites a part. Bytes that would lie outside are ignored.
    void update(std::size_t offset, std::span<const std::byte> content);
    /// Sets all bytes to zero.
    void clear(const Capabilities& capabilities);
    /// Copies the other buffer's content, as much of it as fits.
    void copyFrom(const Buffer& other);
    /// Copies bytes of the other buffer. Bytes that would lie outside of either are left out.
    void copyFrom(const Buffer& other, std::size_t from, std::size_t to, std::size_t bytes);
    /// Reads bytes from `offset` on. Waits for the device. Bytes that would lie outside are left as they are.
    /// Throws std::bad_alloc if the driver lacks the memory.
    void read(std::size_t offset, std::span<std::byte> content) const;
    /// Binds the whole buffer to an indexed binding point: GL_UNIFORM_BUFFER,
    /// GL_SHADER_STORAGE_BUFFER, GL_ATOMIC_COUNTER_BUFFER.
    void bindBase(GLenum target, GLuint index) const { glBindBufferBase(target, index, id()); }
    void bind(GLenum target) const { glBindBuffer(target, id()); }

    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Another number for each content of each buffer of this process, as long as no shader writes it.
    [[nodiscard]] std::uint64_t content() const { return content_; }

  private:
    static std::uint64_t nextContent();
    static Result<Buffer> allocate(const std::byte* content, std::size_t bytes, GLenum usage);
    Name<glDeleteBuffers> name_;
    std::size_t size_ = 0;
    std::uint64_t content_ = nextContent();
};

// Buffers that shaders read as textures: samplerBuffer, imageBuffer and their like.

/// A texture without texels of its own: those are the bytes of a buffer from its beginning on.
class BufferTexture {
  public:
    /// Binds it to a texture image unit, with the texels of that buffer. The format is one of r32f, rg32f,
    /// rgba32f and the integers of these sizes (OpenGL 4.1 core, table 3.15).
    void bind(int unit, const Buffer& buffer, TexelFormat format) const;
    /// The same with an image unit (GL 4.2). `as`: the format that the shader sees.
    void bindImage(int unit, const Buffer& buffer, TexelFormat format, TexelFormat as) const;

  private:
    Name<glDeleteTextures> name_{glGenTextures};
};

// Which buffer feeds which vertex input, constant values for inputs that no buffer feeds, and indices of
// edges.

/// One vertex input read from a buffer.
struct AttributeSource {
    /// 32 bits each. `...AsFloat`: integers in memory that the shader reads as floats.
    enum class Type { floating, integer, unsignedInteger, integerAsFloat, unsignedAsFloat };
    const Buffer* buffer = nullptr;
    GLuint location = 0;
    int components = 4;  ///< 1..4; missing ones read as 0, 0, 1 (y, z, w)
    Type type = Type::floating;
    std::size_t offset = 0;  ///< bytes to the first vertex
    std::size_t stride = 0;  ///< bytes from vertex to vertex; 0: tightly packed
    GLuint divisor = 0;      ///< 0: one value per vertex; n: one value per n instances
};

class VertexArray {
  public:
    /// The buffers must outlive every draw with the vertex array. `indices`, if given, holds 32-bit indices.
    explicit VertexArray(std::span<const AttributeSource> sources, const Buffer* indices = nullptr);
    void bind() const { glBindVertexArray(name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<glDeleteVertexArrays> name_{glGenVertexArrays};
};

/// Sets what an input of that type reads when no buffer feeds it. A matrix gets the value in every column.
/// This is state of the context, not of a vertex array.
void setConstantAttribute(GLuint location, const base::ValueType& type, const std::array<double, 4>& value);

// OpenGL ES fills triangles only. Where a scene draws their edges, these are lines of their own.

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
