#pragma once
// What a texture is made of: its shape, size, format, levels and samples.

#include <glad/gl.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "gpu/format/pixel_format.h"

namespace glibra::gpu {

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

}  // namespace glibra::gpu
