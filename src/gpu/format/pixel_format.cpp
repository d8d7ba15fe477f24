#include "gpu/format/pixel_format.h"

namespace glibra::gpu {

GLenum internalFormat(TexelFormat format) {
    switch (format) {
        case TexelFormat::rgba8:
            return GL_RGBA8;
        case TexelFormat::rgba16:
            return GL_RGBA16;
        case TexelFormat::rgba16f:
            return GL_RGBA16F;
        case TexelFormat::rgba32f:
            return GL_RGBA32F;
        case TexelFormat::r32f:
            break;
    }
    return GL_R32F;
}

const char* name(TexelFormat format) {
    switch (format) {
        case TexelFormat::rgba8:
            return "RGBA8";
        case TexelFormat::rgba16:
            return "RGBA16";
        case TexelFormat::rgba16f:
            return "RGBA16F";
        case TexelFormat::rgba32f:
            return "RGBA32F";
        case TexelFormat::r32f:
            break;
    }
    return "R32F";
}

GLenum glType(TexelType type) {
    switch (type) {
        case TexelType::u8:
            return GL_UNSIGNED_BYTE;
        case TexelType::u16:
            return GL_UNSIGNED_SHORT;
        case TexelType::f32:
            break;
    }
    return GL_FLOAT;
}

GLenum glFormat(int components) {
    switch (components) {
        case 1:
            return GL_RED;
        case 2:
            return GL_RG;
        case 3:
            return GL_RGB;
        default:
            return GL_RGBA;
    }
}

}  // namespace glibra::gpu
