#pragma once
// Pixel formats on the device and in memory.

#include <glad/gl.h>

#include <cstddef>

namespace glibra::gpu {

/// A format on the device.
enum class TexelFormat { rgba8, rgba16, rgba16f, rgba32f, r32f };

/// One component in memory.
enum class TexelType { u8, u16, f32 };

constexpr std::size_t bytesOf(TexelType type) {
    return type == TexelType::u8 ? 1 : type == TexelType::u16 ? 2 : 4;
}
constexpr std::size_t bytesPerTexel(TexelFormat format) {
    switch (format) {
        case TexelFormat::rgba8:
        case TexelFormat::r32f:
            return 4;
        case TexelFormat::rgba16:
        case TexelFormat::rgba16f:
            return 8;
        case TexelFormat::rgba32f:
            break;
    }
    return 16;
}
/// True if the format keeps values outside 0..1.
constexpr bool isFloat(TexelFormat format) {
    return format != TexelFormat::rgba8 && format != TexelFormat::rgba16;
}

/// GL_RGBA8 and so on.
GLenum internalFormat(TexelFormat format);
/// "RGBA8" and so on, for messages.
const char* name(TexelFormat format);
/// GL_UNSIGNED_BYTE and so on.
GLenum glType(TexelType type);
/// GL_RED, GL_RG, GL_RGB, GL_RGBA for 1..4.
GLenum glFormat(int components);

}  // namespace glibra::gpu
