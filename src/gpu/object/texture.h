#pragma once
// Textures: their texels, levels and layers, and what they share.

#include <glad/gl.h>
#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"
#include "gpu/object/texture_shape.h"

namespace glibra::gpu {

/// Texels in memory, tightly packed: the components of a texel, then s, t, p; t = 0 first. A cube map has six
/// faces in the order +x -x +y -y +z -z, each with GL's first row first. Textures of integers take integers
/// only. A depth texture takes one component.
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
    /// The same with levels or samples, or without a value. Samples start as zero where the driver can draw
    /// into the format.
    static Result<Texture> create(const Capabilities& capabilities, const TextureLayout& layout);

    /// Replaces a whole level. Reports gpu-E03 for the wrong number of bytes. Not for multisampled textures.
    Diagnostics upload(int level, const Texels& texels);
    /// Sets all texels of all levels to zero.
    void clear(const Capabilities& capabilities);
    /// Makes all levels from level 0. Only for formats that can be filtered and drawn into.
    void generateMipmaps();
    /// Reads a whole level, laid out like Texels. Formats with stencil give their depth.
    [[nodiscard]] Result<std::vector<std::byte>> read(int level, int components, TexelType type) const;

    /// A texture that shows one level of this one, or all, and one layer or face, or all. A layer or face is
    /// 2D, that of a 1D array 1D. Both share their texels. Needs GL 4.3. Not for a layer of a 3D texture.
    [[nodiscard]] Result<Texture> view(std::optional<int> level, std::optional<int> layer) const;
    /// Copies a layer of a level of `from`, which has the size and format of this 2D texture. Needs GL 4.3.
    void copyLayer(const Texture& from, int level, int layer);
    /// Samplers read these levels only; the first counts from 0.
    void showLevels(int first, int count) const;

    /// Binds the texture to a texture image unit of the context (not a unit of the scene language). create()
    /// uses unit 0 and leaves its texture bound there.
    void bind(int unit) const;
    /// Binds a level to an image unit (GL 4.2), with all layers or faces or only one of them. `access` is
    /// GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE. `as`: the format that the shader sees, whose texels have
    /// the size of this one's; another one is ignored.
    void bindImage(int unit, int level, std::optional<int> layer, GLenum access,
                   std::optional<TexelFormat> as = {}) const;

    [[nodiscard]] GLuint id() const { return name_.get(); }
    [[nodiscard]] TextureShape shape() const { return shape_; }
    [[nodiscard]] TexelFormat format() const { return format_; }
    [[nodiscard]] TextureSize size() const { return size_; }
    [[nodiscard]] int levels() const { return levels_; }
    [[nodiscard]] int samples() const { return samples_; }
    /// Layers that a framebuffer can select: 6 for a cube map, the depth at that level for 3D, 1 for 2D.
    [[nodiscard]] int layers(int level = 0) const;

  private:
    static Result<Texture> make(const Capabilities& capabilities, TextureLayout layout);
    Name<glDeleteTextures> name_;
    TextureShape shape_ = TextureShape::texture2D;
    TexelFormat format_ = TexelFormat::rgba8;
    TextureSize size_;
    int levels_ = 1, samples_ = 1;
};

/// Averages the samples of a multisampled texture into a 2D texture or array of the same format and size. Not
/// for integers and depth. The scissor test must be off.
void resolveSamples(const Texture& from, const Texture& to);

}  // namespace glibra::gpu
