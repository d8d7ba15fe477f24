#include "gpu/object/texture_shape.h"

#include <algorithm>
#include <array>
#include <bit>

namespace glibra::gpu {

GLenum glTarget(TextureShape shape) {
    constexpr std::array<GLenum, kTextureShapes> kTargets{GL_TEXTURE_1D,
                                                          GL_TEXTURE_2D,
                                                          GL_TEXTURE_3D,
                                                          GL_TEXTURE_CUBE_MAP,
                                                          GL_TEXTURE_1D_ARRAY,
                                                          GL_TEXTURE_2D_ARRAY,
                                                          GL_TEXTURE_CUBE_MAP_ARRAY,
                                                          GL_TEXTURE_RECTANGLE,
                                                          GL_TEXTURE_2D_MULTISAMPLE,
                                                          GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
    return kTargets.at(static_cast<std::size_t>(shape));
}

TextureShape shapeOfLayer(TextureShape shape) {
    if (shape == TextureShape::texture1D || shape == TextureShape::array1D) return TextureShape::texture1D;
    if (shape == TextureShape::rectangle) return shape;
    return isMultisampled(shape) ? TextureShape::multisampled : TextureShape::texture2D;
}

TextureSize sizeOfLevel(TextureShape shape, TextureSize size, int level) {
    const auto smaller = [&](int side) { return std::max(1, side >> std::min(level, 30)); };
    return {smaller(size.width), smaller(size.height), isArray(shape) ? size.depth : smaller(size.depth)};
}

int mostLevels(TextureShape shape, TextureSize size) {
    if (isMultisampled(shape) || shape == TextureShape::rectangle) return 1;
    const int depth = shape == TextureShape::texture3D ? size.depth : 1;
    return static_cast<int>(
        std::bit_width(static_cast<unsigned>(std::max({1, size.width, size.height, depth}))));
}

std::string describe(TextureShape shape, TexelFormat format, TextureSize size) {
    std::string text = "a " + std::to_string(size.width);
    if (shapeOfLayer(shape) != TextureShape::texture1D) text += " x " + std::to_string(size.height);
    if (shape == TextureShape::texture3D) text += " x " + std::to_string(size.depth);
    if (isArray(shape))
        text += ", " + std::to_string(isCube(shape) ? size.depth / 6 : size.depth) + " layers";
    return text + (isCube(shape) ? " cube map (" : " texture (") + std::string(name(format)) + ")";
}

std::uint64_t texelCount(TextureShape shape, TextureSize size) {
    const auto count = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) *
                       static_cast<std::uint64_t>(size.depth);
    return shape == TextureShape::cube ? 6 * count : count;
}

}  // namespace glibra::gpu
