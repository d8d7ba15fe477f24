#pragma once
// Textures: their texels, levels and layers, and what they share.

#include <glad/gl.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/raster_state.h"
#include "gpu/context/capabilities.h"
#include "gpu/format/pixel_format.h"
#include "gpu/object/name.h"

namespace glibra::gpu {

// What a texture is made of: its shape, size, format, levels and samples.

/// `array1D`, `array2D`: layers of 1D or 2D textures. `cubeArray`: cube maps, whose layers are their faces.
/// `rectangle`: 2D without levels, sampled by texel coordinates. `multisampled`, `multisampledArray`: 2D and
/// its layers without levels, drawn into and read by texelFetch.
enum class TextureShape {
    texture1D,
    texture2D,
    texture3D,
    cube,
    array1D,
    array2D,
    cubeArray,
    rectangle,
    multisampled,
    multisampledArray
};
inline constexpr std::size_t kTextureShapes = 10;

constexpr bool isMultisampled(TextureShape shape) {
    return shape == TextureShape::multisampled || shape == TextureShape::multisampledArray;
}
constexpr bool isArray(TextureShape shape) {
    return shape == TextureShape::array1D || shape == TextureShape::array2D ||
           shape == TextureShape::cubeArray || shape == TextureShape::multisampledArray;
}
constexpr bool isCube(TextureShape shape) {
    return shape == TextureShape::cube || shape == TextureShape::cubeArray;
}

/// GL_TEXTURE_1D and so on.
GLenum glTarget(TextureShape shape);
/// The shape of one layer or face: of all but 1D and multisampled arrays, 2D.
TextureShape shapeOfLayer(TextureShape shape);

/// Size in texels; an unused dimension is 1. A cube map has width = height. The depth of an array is its
/// number of layers, six for each cube map.
struct TextureSize {
    int width = 1, height = 1, depth = 1;
    friend bool operator==(const TextureSize&, const TextureSize&) = default;
};

/// The size of a mipmap level, 0 being the largest. Layers of an array do not become fewer.
TextureSize sizeOfLevel(TextureShape shape, TextureSize size, int level);
/// Levels down to one texel.
int mostLevels(TextureShape shape, TextureSize size);

/// All texels of a level of that size, those of all faces together.
std::uint64_t texelCount(TextureShape shape, TextureSize size);
/// For messages: "a 256 x 128 texture (rgba8)".
std::string describe(TextureShape shape, TexelFormat format, TextureSize size);

/// The storage of a texture.
struct TextureLayout {
    TextureShape shape = TextureShape::texture2D;
    TexelFormat format = TexelFormat::rgba8;
    TextureSize size{};
    int levels = 1;   ///< 1..mostLevels
    int samples = 1;  ///< of multisampled shapes; the driver may give more
    /// False: the texels have no known values until something writes all of them.
    bool isFilled = true;
};

// Private to this folder: the memory of a texture's texels.

// Uploads and queries use this unit and replace its binding; every draw binds its own textures.
inline constexpr int kWorkUnit = 0;

/// The driver's limit of width, height and, except for arrays, depth.
int largestSide(const Capabilities& capabilities, TextureShape shape);
/// Allocates the texels of the bound texture; from GL 4.2 on as immutable storage.
void allocate(const Capabilities& capabilities, const TextureLayout& layout);
/// Fills a level of the bound texture, which has one sample. `faceBytes`: bytes of one face of a cube map.
void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes);

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

/// Reads a level layer by layer, through a framebuffer. Only for formats that can be drawn into.
void readLayers(const Texture& texture, int level, GLenum format, GLenum type, std::span<std::byte> texels);

/// Averages the samples of a multisampled texture into a 2D texture or array of the same format and size. Not
/// for integers and depth. The scissor test must be off.
void resolveSamples(const Texture& from, const Texture& to);

// Samplers: how a texture is read.

using base::SamplerState;
using base::Wrap;

/// True for filters that read one texel of a level.
bool isNearest(base::Filter filter);

class Sampler {
  public:
    /// `compare`: for sampler2DShadow and its like, which read 1 where (reference compared with texel) holds,
    /// else 0. Anisotropy above 1 needs a driver that supports it.
    explicit Sampler(const SamplerState& state = {}, std::optional<base::Comparison> compare = {});
    /// Linear, with the same wrapping in every direction.
    explicit Sampler(Wrap wrap) : Sampler(SamplerState{.wrap = {wrap, wrap, wrap}, .border = {}}) {}
    void bind(int unit) const { glBindSampler(static_cast<GLuint>(unit), name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<glDeleteSamplers> name_{glGenSamplers};
};

}  // namespace glibra::gpu
