#pragma once
// Textures and, apart from them, samplers: how a texture is read.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "gpu/capabilities.h"
#include "gpu/name.h"
#include "gpu/pixel_format.h"

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

/// Texels; what a shape has no use for is 1. A cube map has width = height.
struct TextureSize {
    int width = 1, height = 1, depth = 1;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

/// Texels in memory, tightly packed: components of a texel, then s, t, p; t = 0 first. A cube map's six faces
/// follow one another in the order +x -x +y -y +z -z, each with GL's own first row first.
struct Texels {
    std::span<const std::byte> data;
    int components = 4;  ///< 1..4; missing ones read 0 (green, blue) and 1 (alpha)
    TexelType type = TexelType::u8;
};

class Texture {
  public:
    /// One level, no mipmaps. `texels` must hold exactly the size's bytes (gpu-E03 otherwise). Sizes beyond
    /// the driver's limits: gpu-E04, which names the limit. No memory: draw-E05.
    static Result<Texture> create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                  TextureSize size, const Texels& texels);
    /// All texels (0, 0, 0, 0).
    static Result<Texture> create(const Capabilities& capabilities, TextureShape shape, TexelFormat format,
                                  TextureSize size);

    /// What the components read when sampled: GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_ZERO, GL_ONE.
    void setSwizzle(const std::array<GLint, 4>& components);

    /// Binds to a texture image unit of the context (not the unit of the scene language). create() and
    /// setSwizzle() use unit 0 and leave their texture there.
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

/// How texels become a value. The default is linear without mipmaps.
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
