#include "gpu/object/buffer_texture.h"

namespace glibra::gpu {

void BufferTexture::bind(int unit, const Buffer& buffer, TexelFormat format) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, name_.get());
    glTexBuffer(GL_TEXTURE_BUFFER, internalFormat(format), buffer.id());
}

void BufferTexture::bindImage(int unit, const Buffer& buffer, TexelFormat format, TexelFormat as) const {
    // Samplers keep what they read on unit 0.
    GLint sampled = 0;
    glActiveTexture(GL_TEXTURE0);
    glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &sampled);
    bind(0, buffer, format);
    glBindTexture(GL_TEXTURE_BUFFER, static_cast<GLuint>(sampled));
    glBindImageTexture(static_cast<GLuint>(unit), name_.get(), 0, GL_FALSE, 0, GL_READ_WRITE,
                       internalFormat(as));
}

}  // namespace glibra::gpu
