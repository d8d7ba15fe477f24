#pragma once
// Buffers that shaders read as textures: samplerBuffer, imageBuffer and their like.

#include <glad/gl.h>

#include "gpu/format/pixel_format.h"
#include "gpu/object/buffer.h"
#include "gpu/object/texture.h"

namespace glibra::gpu {

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
