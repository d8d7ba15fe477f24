#pragma once

#include <glibra/result.h>

#include <glad/gl.h>
#include <cstddef>
#include <cstdint>
#include <span>

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

}  // namespace glibra::gpu
