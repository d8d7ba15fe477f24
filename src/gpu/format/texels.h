#pragma once
// OpenGL ES takes the texels of a format in one layout, and gives pixels in few.

#include <glad/gl.h>

#include <cstddef>
#include <span>
#include <vector>

#include "gpu/format/pixel_format.h"

namespace glibra::gpu {

/// The layout of a texel or pixel in memory: 1 to 4 components in the order red, green, blue, alpha.
struct TexelLayout {
    int components = 4;
    TexelType type = TexelType::u8;
    [[nodiscard]] std::size_t bytes() const { return static_cast<std::size_t>(components) * bytesOf(type); }
    friend bool operator==(const TexelLayout&, const TexelLayout&) = default;
};

/// Texels in another layout. Missing components become 0, alpha 1. `isNormalized`: whole numbers stand for
/// 0..1 or -1..1, and are rounded to nearest; otherwise numbers stay themselves.
std::vector<std::byte> converted(std::span<const std::byte> texels, TexelLayout from, TexelLayout to,
                                 bool isNormalized);

/// The type of GL_UNSIGNED_BYTE and so on; floats for all others.
TexelType typeOf(GLenum type);
/// The texels in the layout of nativeTransfer().
std::vector<std::byte> forEs(std::span<const std::byte> texels, TexelLayout layout, TexelFormat format);

}  // namespace glibra::gpu
