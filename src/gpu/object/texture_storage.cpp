#include "gpu/object/texture_storage.h"

namespace glibra::gpu {
namespace {

/// The sizes by which GL stores a level. The layers of a 1D array are its second one.
struct Sides {
    int count = 2;
    GLsizei width = 1, height = 1, depth = 1;
};

Sides sidesOf(TextureShape shape, TextureSize size) {
    if (shape == TextureShape::texture1D) return {1, size.width};
    if (shape == TextureShape::array1D) return {2, size.width, size.depth};
    if (shape == TextureShape::texture3D || isArray(shape)) return {3, size.width, size.height, size.depth};
    return {2, size.width, size.height};
}

/// Allocates one level by the calls of GL 4.1.
void allocateLevel(TextureShape shape, TexelFormat format, TextureSize size, int level) {
    const GLenum target = glTarget(shape);
    const auto inside = static_cast<GLint>(internalFormat(format));
    const auto [layout, type] = nativeTransfer(format);
    const auto [count, width, height, depth] = sidesOf(shape, size);
    if (shape == TextureShape::cube)
        for (GLenum face = 0; face < 6; ++face)
            glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, inside, width, height, 0, layout, type,
                         nullptr);
    else if (count == 1)
        glTexImage1D(target, level, inside, width, 0, layout, type, nullptr);
    else if (count == 2)
        glTexImage2D(target, level, inside, width, height, 0, layout, type, nullptr);
    else
        glTexImage3D(target, level, inside, width, height, depth, 0, layout, type, nullptr);
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
    if (shape == TextureShape::rectangle) return capabilities.maxRectangleSide;
    if (shape == TextureShape::texture3D) return capabilities.max3DTextureSide;
    // GL has one limit for 1D and 2D.
    return isCube(shape) ? capabilities.maxCubeSide : capabilities.max2DTextureSide;
}

void allocate(const Capabilities& capabilities, const TextureLayout& layout) {
    if (isMultisampled(layout.shape)) return allocateSamples(capabilities, layout);
    if (!capabilities.atLeast(4, 2)) {
        for (int level = 0; level < layout.levels; ++level)
            allocateLevel(layout.shape, layout.format, sizeOfLevel(layout.shape, layout.size, level), level);
        return;
    }
    const GLenum target = glTarget(layout.shape);
    const GLenum inside = internalFormat(layout.format);
    const auto [count, width, height, depth] = sidesOf(layout.shape, layout.size);
    if (count == 1)
        glTexStorage1D(target, layout.levels, inside, width);
    else if (count == 2)
        glTexStorage2D(target, layout.levels, inside, width, height);
    else
        glTexStorage3D(target, layout.levels, inside, width, height, depth);
}

void fillLevel(TextureShape shape, TextureSize size, int level, Transfer transfer, const std::byte* data,
               std::size_t faceBytes) {
    const auto [format, type] = transfer;
    const GLenum target = glTarget(shape);
    const auto [count, width, height, depth] = sidesOf(shape, size);
    if (shape == TextureShape::cube)
        for (GLenum i = 0; i < 6; ++i)
            glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, level, 0, 0, width, height, format, type,
                            data + i * faceBytes);
    else if (count == 1)
        glTexSubImage1D(target, level, 0, width, format, type, data);
    else if (count == 2)
        glTexSubImage2D(target, level, 0, 0, width, height, format, type, data);
    else
        glTexSubImage3D(target, level, 0, 0, 0, width, height, depth, format, type, data);
}

}  // namespace glibra::gpu
