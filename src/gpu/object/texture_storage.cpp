#include "gpu/object/texture_storage.h"

namespace glibra::gpu {
namespace {

/// Allocates one level by the calls of GL 4.1.
void allocateLevel(TextureShape shape, TexelFormat format, TextureSize size, int level) {
    const GLenum target = glTarget(shape);
    const auto inside = static_cast<GLint>(internalFormat(format));
    const auto [layout, type] = nativeTransfer(format);
    switch (shape) {
        case TextureShape::texture1D:
            glTexImage1D(target, level, inside, size.width, 0, layout, type, nullptr);
            break;
        case TextureShape::texture2D:
        case TextureShape::rectangle:
            glTexImage2D(target, level, inside, size.width, size.height, 0, layout, type, nullptr);
            break;
        case TextureShape::array1D:
            glTexImage2D(target, level, inside, size.width, size.depth, 0, layout, type, nullptr);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
        case TextureShape::cubeArray:
            glTexImage3D(target, level, inside, size.width, size.height, size.depth, 0, layout, type,
                         nullptr);
            break;
        case TextureShape::cube:
            for (GLenum face = 0; face < 6; ++face)
                glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, inside, size.width, size.height, 0,
                             layout, type, nullptr);
            break;
        case TextureShape::multisampled:
        case TextureShape::multisampledArray:
            break;
    }
}

/// Allocates all samples. Their positions are those of renderbuffers, which such textures are drawn together
/// with.
void allocateSamples(const Capabilities& capabilities, const TextureLayout& layout) {
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto& [width, height, depth] = layout.size;
    const bool hasStorage = capabilities.atLeast(4, 3);
    if (isArray(layout.shape)) {
        const auto store = hasStorage ? glTexStorage3DMultisample : glTexImage3DMultisample;
        return store(target, layout.samples, inside, width, height, depth, GL_TRUE);
    }
    const auto store = hasStorage ? glTexStorage2DMultisample : glTexImage2DMultisample;
    store(target, layout.samples, inside, width, height, GL_TRUE);
}

}  // namespace

int largestSide(const Capabilities& capabilities, TextureShape shape) {
    switch (shape) {
        case TextureShape::texture1D:
        case TextureShape::array1D:  // GL has one limit for 1D and 2D
        case TextureShape::texture2D:
        case TextureShape::array2D:
        case TextureShape::multisampled:
        case TextureShape::multisampledArray:
            return capabilities.max2DTextureSide;
        case TextureShape::rectangle:
            return capabilities.maxRectangleSide;
        case TextureShape::texture3D:
            return capabilities.max3DTextureSide;
        case TextureShape::cube:
        case TextureShape::cubeArray:
            break;
    }
    return capabilities.maxCubeSide;
}

void allocate(const Capabilities& capabilities, const TextureLayout& layout) {
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto& [width, height, depth] = layout.size;
    if (isMultisampled(layout.shape)) return allocateSamples(capabilities, layout);
    if (!capabilities.atLeast(4, 2)) {
        for (int level = 0; level < layout.levels; ++level)
            allocateLevel(layout.shape, layout.format, sizeOfLevel(layout.shape, layout.size, level), level);
        return;
    }
    switch (layout.shape) {
        case TextureShape::texture1D:
            glTexStorage1D(target, layout.levels, inside, width);
            break;
        case TextureShape::array1D:
            glTexStorage2D(target, layout.levels, inside, width, depth);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
        case TextureShape::cubeArray:
            glTexStorage3D(target, layout.levels, inside, width, height, depth);
            break;
        default:
            glTexStorage2D(target, layout.levels, inside, width, height);
            break;
    }
}

void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes) {
    const auto [format, type] = transfer;
    switch (shape) {
        case TextureShape::texture1D:
            glTexSubImage1D(GL_TEXTURE_1D, level, 0, size.width, format, type, data);
            break;
        case TextureShape::texture2D:
        case TextureShape::rectangle:
            glTexSubImage2D(glTarget(shape), level, 0, 0, size.width, size.height, format, type, data);
            break;
        case TextureShape::array1D:
            glTexSubImage2D(glTarget(shape), level, 0, 0, size.width, size.depth, format, type, data);
            break;
        case TextureShape::texture3D:
        case TextureShape::array2D:
        case TextureShape::cubeArray:
            glTexSubImage3D(glTarget(shape), level, 0, 0, 0, size.width, size.height, size.depth, format,
                            type, data);
            break;
        case TextureShape::cube:
            for (GLenum i = 0; i < 6; ++i)
                glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, level, 0, 0, size.width, size.height,
                                format, type, data + i * faceBytes);
            break;
        case TextureShape::multisampled:
        case TextureShape::multisampledArray:
            break;
    }
}

}  // namespace glibra::gpu
