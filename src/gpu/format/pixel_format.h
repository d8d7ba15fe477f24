#pragma once
// Pixel formats on the device and in memory.

#include <glad/gl.h>

#include <cstddef>
#include <span>
#include <vector>

#include "base/texel_format.h"
#include "gpu/context/capabilities.h"

namespace glibra::gpu {

using base::bytesPerTexel;
using base::hasDepth;
using base::hasStencil;
using base::isFloat;
using base::isInteger;
using base::TexelFormat;

/// One component in memory.
enum class TexelType { u8, u16, u32, i8, i16, i32, f32 };

constexpr std::size_t bytesOf(TexelType type) {
    switch (type) {
        case TexelType::u8:
        case TexelType::i8:
            return 1;
        case TexelType::u16:
        case TexelType::i16:
            return 2;
        default:
            return 4;
    }
}

/// GL_RGBA8 and so on.
GLenum internalFormat(TexelFormat format);

/// The format and type of texels in memory, as glTexSubImage2D and glGetTexImage take them.
struct Transfer {
    GLenum format = GL_RGBA, type = GL_UNSIGNED_BYTE;
};
/// The layout that loses nothing; a texel takes bytesPerTexel bytes.
Transfer nativeTransfer(TexelFormat format);

/// What the driver can do with textures of a format.
struct FormatUse {
    bool color = false;    ///< can be a colour of a framebuffer
    bool depth = false;    ///< can be its depth
    bool stencil = false;  ///< can be its stencil too
    bool blend = false;    ///< colours can be blended
    bool filter = false;   ///< can be sampled with linear filters
    bool image = false;    ///< image units can load and store
    int samples = 0;       ///< largest number of samples; 0: cannot be multisampled
};
/// The driver's own answer from GL 4.3 on; below, what GL guarantees.
FormatUse useOf(const Capabilities& capabilities, TexelFormat format);

/// GL_UNSIGNED_BYTE and so on.
GLenum glType(TexelType type);
/// GL_RED, GL_RG, GL_RGB, GL_RGBA for 1..4.
GLenum glFormat(int components);
/// The same for texels of a texture of that format: GL_RED_INTEGER ... for integers, GL_DEPTH_COMPONENT for
/// depth.
GLenum glFormat(int components, TexelFormat format);

// OpenGL ES takes the texels of a format in one layout, and gives pixels in few.

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
