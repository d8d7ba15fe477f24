#pragma once
// Pixel formats on the device and in memory.

#include <glad/gl.h>

#include <cstddef>

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

}  // namespace glibra::gpu
