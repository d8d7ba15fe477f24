#pragma once
// Textures, and samplers, which say how a texture is read.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

inline void deleteTexture(GLuint name) {
    glDeleteTextures(1, &name);
}
inline void deleteSampler(GLuint name) {
    glDeleteSamplers(1, &name);
}

enum class TextureShape { texture1D, texture2D, texture3D, cube };

/// GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP.
GLenum glTarget(TextureShape shape);

/// Size in texels; an unused dimension is 1. A cube map has width = height.
struct TextureSize {
    int width = 1, height = 1, depth = 1;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

/// Texels in memory, tightly packed: the components of a texel, then s, t, p; t = 0 first. A cube map has six
/// faces in the order +x -x +y -y +z -z, each with GL's first row first.
struct Texels {
    std::span<const std::byte> data;
    int components = 4;  ///< 1..4; missing ones read as 0 (green, blue) and 1 (alpha)
    TexelType type = TexelType::u8;
};

class Texture {
  public:
    /// Makes one level without mipmaps. `texels` must hold exactly as many bytes as the size needs (gpu-E03).
    /// Reports gpu-E04 with the driver's limit for a size beyond it, and draw-E05 for lack of memory.
    static Result<Texture> create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                  TextureSize size, const Texels& texels);
    /// Makes a texture whose texels are all (0, 0, 0, 0).
    static Result<Texture> create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                  TextureSize size);

    /// Sets what each component reads when sampled: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_ZERO, GL_ONE.
    void setSwizzle(const std::array<GLint, 4>& components);

    /// Binds the texture to a texture image unit of the context (not a unit of the scene language). create()
    /// and setSwizzle() use unit 0 and leave their texture bound there.
    void bind(int unit) const;

    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] TextureShape shape() const { return shape_; }
    [[nodiscard]] TexelFormat format() const { return format_; }
    [[nodiscard]] TextureSize size() const { return size_; }

  private:
    static Result<Texture> make(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                TextureSize size);
    void clear();
    Name<deleteTexture> name_;
    TextureShape shape_ = TextureShape::texture2D;
    TexelFormat format_ = TexelFormat::rgba8;
    TextureSize size_;
};

enum class Wrap { repeat, clampToEdge, mirroredRepeat };

/// How texels are filtered and wrapped. The default is linear without mipmaps.
struct Sampling {
    Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat, wrapR = Wrap::repeat;
    GLenum minify = GL_LINEAR;
    GLenum magnify = GL_LINEAR;
    float anisotropy = 1;
};

class Sampler {
  public:
    explicit Sampler(const Sampling& sampling = {});
    /// The same wrapping in every direction.
    explicit Sampler(Wrap wrap) : Sampler(Sampling{wrap, wrap, wrap, GL_LINEAR, GL_LINEAR, 1}) {}
    void bind(int unit) const { glBindSampler(static_cast<GLuint>(unit), name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<deleteSampler> name_;
};

}  // namespace glibra::gpu
