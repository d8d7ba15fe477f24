#include "gpu/object/texture.h"

#include <string>
#include <vector>

#include "gpu/context/errors.h"

namespace glibra::gpu {
namespace {

// Uploads and queries use this unit and replace its binding; every draw binds its own textures.
constexpr GLenum kWorkUnit = GL_TEXTURE0;

int largestSide(const Capabilities& capabilities, TextureShape shape) {
    switch (shape) {
        case TextureShape::texture1D:
            return capabilities.max1DTextureSide;
        case TextureShape::texture2D:
            return capabilities.max2DTextureSide;
        case TextureShape::texture3D:
            return capabilities.max3DTextureSide;
        case TextureShape::cube:
            break;
    }
    return capabilities.maxCubeSide;
}

/// "a 256 x 128 texture (RGBA8)".
std::string describe(TextureShape shape, TexelFormat format, TextureSize size) {
    std::string text = "a " + std::to_string(size.width);
    if (shape != TextureShape::texture1D) text += " x " + std::to_string(size.height);
    if (shape == TextureShape::texture3D) text += " x " + std::to_string(size.depth);
    return text + (shape == TextureShape::cube ? " cube map (" : " texture (") + name(format) + ")";
}

std::uint64_t texelCount(TextureShape shape, TextureSize size) {
    const auto count = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                       static_cast<std::uint64_t>(size.depth);
    return shape == TextureShape::cube ? 6 * count : count;
}

/// Allocates the texels; from GL 4.2 on as immutable storage.
void allocate(bool immutable, TextureShape shape, TexelFormat format, TextureSize size) {
    const GLenum target = glTarget(shape);
    const GLenum inside = internalFormat(format);
    const auto loose = static_cast<GLint>(inside);
    switch (shape) {
        case TextureShape::texture1D:
            if (immutable)
                glTexStorage1D(target, 1, inside, size.width);
            else
                glTexImage1D(target, 0, loose, size.width, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            break;
        case TextureShape::texture2D:
            if (immutable)
                glTexStorage2D(target, 1, inside, size.width, size.height);
            else
                glTexImage2D(target, 0, loose, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                             nullptr);
            break;
        case TextureShape::texture3D:
            if (immutable)
                glTexStorage3D(target, 1, inside, size.width, size.height, size.depth);
            else
                glTexImage3D(target, 0, loose, size.width, size.height, size.depth, 0, GL_RGBA,
                             GL_UNSIGNED_BYTE, nullptr);
            break;
        case TextureShape::cube:
            if (immutable) {
                glTexStorage2D(target, 1, inside, size.width, size.height);
                break;
            }
            for (GLenum face = 0; face < 6; ++face)
                glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, loose, size.width, size.height, 0,
                             GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            break;
    }
}

void upload(TextureShape shape, TextureSize size, const Texels& texels) {
    const GLenum format = glFormat(texels.components);
    const GLenum type = glType(texels.type);
    const std::byte* data = texels.data.data();
    switch (shape) {
        case TextureShape::texture1D:
            glTexSubImage1D(GL_TEXTURE_1D, 0, 0, size.width, format, type, data);
            break;
        case TextureShape::texture2D:
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.width, size.height, format, type, data);
            break;
        case TextureShape::texture3D:
            glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size.width, size.height, size.depth, format, type,
                            data);
            break;
        case TextureShape::cube: {
            const std::size_t face = texels.data.size() / 6;
            for (GLenum i = 0; i < 6; ++i)
                glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, 0, 0, size.width, size.height, format,
                                type, data + i * face);
            break;
        }
    }
}

GLint glWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return GL_REPEAT;
        case Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::mirroredRepeat:
            break;
    }
    return GL_MIRRORED_REPEAT;
}

}  // namespace

GLenum glTarget(TextureShape shape) {
    switch (shape) {
        case TextureShape::texture1D:
            return GL_TEXTURE_1D;
        case TextureShape::texture2D:
            return GL_TEXTURE_2D;
        case TextureShape::texture3D:
            return GL_TEXTURE_3D;
        case TextureShape::cube:
            break;
    }
    return GL_TEXTURE_CUBE_MAP;
}

Result<Texture> Texture::make(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                              TextureSize size) {
    if (shape == TextureShape::texture1D) size.height = 1;
    if (shape != TextureShape::texture3D) size.depth = 1;
    const std::string what = describe(shape, format, size);
    const int largest = largestSide(capabilities, shape);
    if (size.width < 1 || size.height < 1 || size.depth < 1)
        return diagnose("gpu-E04", what + " has no texels");
    if (shape == TextureShape::cube && size.width != size.height)
        return diagnose("gpu-E04", what + " is not square");
    if (size.width > largest || size.height > largest || size.depth > largest)
        return diagnose("gpu-E04", what + " is too large; this driver's limit is " + std::to_string(largest) +
                                       " per side");

    Texture texture;
    GLuint name = 0;
    glGenTextures(1, &name);
    texture.name_ = Name<deleteTexture>(name);
    texture.shape_ = shape;
    texture.format_ = format;
    texture.size_ = size;
    clearErrors();
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape), name);
    allocate(capabilities.atLeast(4, 2), shape, format, size);
    // A texture without mipmaps is complete only with this setting; the sampler sets the filtering.
    glTexParameteri(glTarget(shape), GL_TEXTURE_MAX_LEVEL, 0);
    if (const GLenum code = takeError(); code != GL_NO_ERROR) return allocationError(code, what);
    return texture;
}

Result<Texture> Texture::create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                TextureSize size, const Texels& texels) {
    Result<Texture> made = make(capabilities, shape, format, size);
    if (!made) return made;
    const std::uint64_t needed =
        texelCount(shape, made->size_) * static_cast<std::uint64_t>(texels.components) * bytesOf(texels.type);
    if (texels.components < 1 || texels.components > 4 || needed != texels.data.size())
        return diagnose("gpu-E03", describe(shape, format, made->size_) + " takes " + std::to_string(needed) +
                                       " bytes of texels, not " + std::to_string(texels.data.size()));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    upload(shape, made->size_, texels);
    if (const GLenum code = takeError(); code != GL_NO_ERROR)
        return allocationError(code, describe(shape, format, made->size_));
    return made;
}

Result<Texture> Texture::create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                TextureSize size) {
    Result<Texture> made = make(capabilities, shape, format, size);
    if (made) made->clear();
    return made;
}

void Texture::clear() {
    // glClearTexImage needs GL 4.4. A framebuffer clears layer by layer in every version, and reads no
    // memory.
    GLuint framebuffer = 0;
    GLint drawnBefore = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawnBefore);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const std::array<GLfloat, 4> nothing{};
    const auto clearAttached = [&] {
        glDrawBuffer(GL_COLOR_ATTACHMENT0);
        glClearBufferfv(GL_COLOR, 0, nothing.data());
    };
    switch (shape_) {
        case TextureShape::texture1D:
            glFramebufferTexture1D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, id(), 0);
            clearAttached();
            break;
        case TextureShape::texture2D:
            glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id(), 0);
            clearAttached();
            break;
        case TextureShape::texture3D:
            for (int layer = 0; layer < size_.depth; ++layer) {
                glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, id(), 0, layer);
                clearAttached();
            }
            break;
        case TextureShape::cube:
            for (GLenum face = 0; face < 6; ++face) {
                glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                       GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, id(), 0);
                clearAttached();
            }
            break;
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawnBefore));
    glDeleteFramebuffers(1, &framebuffer);
}

void Texture::setSwizzle(const std::array<GLint, 4>& components) {
    glActiveTexture(kWorkUnit);
    glBindTexture(glTarget(shape_), id());
    glTexParameteriv(glTarget(shape_), GL_TEXTURE_SWIZZLE_RGBA, components.data());
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(glTarget(shape_), id());
}

Sampler::Sampler(const Sampling& sampling) {
    GLuint name = 0;
    glGenSamplers(1, &name);
    name_ = Name<deleteSampler>(name);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, glWrap(sampling.wrapS));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, glWrap(sampling.wrapT));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_R, glWrap(sampling.wrapR));
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(sampling.minify));
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(sampling.magnify));
    if (sampling.anisotropy > 1)
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, sampling.anisotropy);
}

}  // namespace glibra::gpu
