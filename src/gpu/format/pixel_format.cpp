#include "gpu/format/pixel_format.h"

#include <array>

namespace glibra::gpu {
namespace {

/// One row of GL numbers: the internal format, and the layout in memory that loses nothing.
struct GlRow {
    TexelFormat format;
    GLenum internal, transferFormat, transferType;
};

constexpr std::array<GlRow, base::kTexelFormatCount> kRows{{
    {TexelFormat::r8, GL_R8, GL_RED, GL_UNSIGNED_BYTE},
    {TexelFormat::rg8, GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
    {TexelFormat::rgba8, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {TexelFormat::r16, GL_R16, GL_RED, GL_UNSIGNED_SHORT},
    {TexelFormat::rg16, GL_RG16, GL_RG, GL_UNSIGNED_SHORT},
    {TexelFormat::rgba16, GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
    {TexelFormat::r8_snorm, GL_R8_SNORM, GL_RED, GL_BYTE},
    {TexelFormat::rg8_snorm, GL_RG8_SNORM, GL_RG, GL_BYTE},
    {TexelFormat::rgba8_snorm, GL_RGBA8_SNORM, GL_RGBA, GL_BYTE},
    {TexelFormat::r16_snorm, GL_R16_SNORM, GL_RED, GL_SHORT},
    {TexelFormat::rg16_snorm, GL_RG16_SNORM, GL_RG, GL_SHORT},
    {TexelFormat::rgba16_snorm, GL_RGBA16_SNORM, GL_RGBA, GL_SHORT},
    {TexelFormat::r16f, GL_R16F, GL_RED, GL_HALF_FLOAT},
    {TexelFormat::rg16f, GL_RG16F, GL_RG, GL_HALF_FLOAT},
    {TexelFormat::rgba16f, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
    {TexelFormat::r32f, GL_R32F, GL_RED, GL_FLOAT},
    {TexelFormat::rg32f, GL_RG32F, GL_RG, GL_FLOAT},
    {TexelFormat::rgba32f, GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {TexelFormat::r8i, GL_R8I, GL_RED_INTEGER, GL_BYTE},
    {TexelFormat::rg8i, GL_RG8I, GL_RG_INTEGER, GL_BYTE},
    {TexelFormat::rgba8i, GL_RGBA8I, GL_RGBA_INTEGER, GL_BYTE},
    {TexelFormat::r16i, GL_R16I, GL_RED_INTEGER, GL_SHORT},
    {TexelFormat::rg16i, GL_RG16I, GL_RG_INTEGER, GL_SHORT},
    {TexelFormat::rgba16i, GL_RGBA16I, GL_RGBA_INTEGER, GL_SHORT},
    {TexelFormat::r32i, GL_R32I, GL_RED_INTEGER, GL_INT},
    {TexelFormat::rg32i, GL_RG32I, GL_RG_INTEGER, GL_INT},
    {TexelFormat::rgba32i, GL_RGBA32I, GL_RGBA_INTEGER, GL_INT},
    {TexelFormat::r8ui, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE},
    {TexelFormat::rg8ui, GL_RG8UI, GL_RG_INTEGER, GL_UNSIGNED_BYTE},
    {TexelFormat::rgba8ui, GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE},
    {TexelFormat::r16ui, GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT},
    {TexelFormat::rg16ui, GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT},
    {TexelFormat::rgba16ui, GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT},
    {TexelFormat::r32ui, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
    {TexelFormat::rg32ui, GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
    {TexelFormat::rgba32ui, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
    {TexelFormat::srgb8_alpha8, GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {TexelFormat::r11f_g11f_b10f, GL_R11F_G11F_B10F, GL_RGB, GL_UNSIGNED_INT_10F_11F_11F_REV},
    {TexelFormat::rgb10_a2, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
    {TexelFormat::depth16, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
    {TexelFormat::depth24, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {TexelFormat::depth32f, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
    {TexelFormat::depth24_stencil8, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8},
    {TexelFormat::depth32f_stencil8, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL,
     GL_FLOAT_32_UNSIGNED_INT_24_8_REV},
}};

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kRows.size(); ++i)
        if (static_cast<std::size_t>(kRows[i].format) != i) return false;
    return true;
}
static_assert(isInOrder());

const GlRow& glRowOf(TexelFormat format) {
    return kRows.at(static_cast<std::size_t>(format));
}

/// The driver's answer about textures of that format in that use; GL_NONE for no.
GLint ask(GLenum target, TexelFormat format, GLenum what) {
    GLint answer = GL_NONE;
    glGetInternalformativ(target, internalFormat(format), what, 1, &answer);
    return answer;
}

/// What every driver of GL 4.1 or 4.2 supports (OpenGL 4.2 core, 3.8.1 and table 3.21).
FormatUse guaranteedUse(const Capabilities& capabilities, TexelFormat format) {
    const base::TexelFormatRow& row = rowOf(format);
    FormatUse use;
    use.depth = hasDepth(format);
    use.stencil = hasStencil(format);
    use.color = !use.depth && row.kind != base::TexelClass::signedNormalized;
    use.filter = !isInteger(format);
    use.blend = use.color && !isInteger(format);
    use.image = capabilities.imageUnits > 0 && !use.depth && format != TexelFormat::srgb8_alpha8;
    if (use.color || use.depth)
        use.samples = isInteger(format) ? capabilities.maxIntegerSamples : capabilities.maxSamples;
    return use;
}

}  // namespace

GLenum internalFormat(TexelFormat format) {
    return glRowOf(format).internal;
}

Transfer nativeTransfer(TexelFormat format) {
    return {glRowOf(format).transferFormat, glRowOf(format).transferType};
}

FormatUse useOf(const Capabilities& capabilities, TexelFormat format) {
    FormatUse use = guaranteedUse(capabilities, format);
    if (!capabilities.atLeast(4, 3)) return use;
    use.color = ask(GL_TEXTURE_2D, format, GL_COLOR_RENDERABLE) == GL_TRUE &&
                ask(GL_TEXTURE_2D, format, GL_FRAMEBUFFER_RENDERABLE) != GL_NONE;
    use.depth = use.depth && ask(GL_TEXTURE_2D, format, GL_DEPTH_RENDERABLE) == GL_TRUE &&
                ask(GL_TEXTURE_2D, format, GL_FRAMEBUFFER_RENDERABLE) != GL_NONE;
    use.stencil = use.stencil && use.depth && ask(GL_TEXTURE_2D, format, GL_STENCIL_RENDERABLE) == GL_TRUE;
    use.filter = use.filter && ask(GL_TEXTURE_2D, format, GL_FILTER) != GL_NONE;
    use.blend =
        use.color && !isInteger(format) && ask(GL_TEXTURE_2D, format, GL_FRAMEBUFFER_BLEND) != GL_NONE;
    use.image = use.image && ask(GL_TEXTURE_2D, format, GL_SHADER_IMAGE_LOAD) != GL_NONE &&
                ask(GL_TEXTURE_2D, format, GL_SHADER_IMAGE_STORE) != GL_NONE;
    use.samples = 0;
    // GL_SAMPLES lists the numbers of samples in descending order.
    if ((use.color || use.depth) && ask(GL_TEXTURE_2D_MULTISAMPLE, format, GL_NUM_SAMPLE_COUNTS) > 0)
        use.samples = ask(GL_TEXTURE_2D_MULTISAMPLE, format, GL_SAMPLES);
    return use;
}

GLenum glType(TexelType type) {
    switch (type) {
        case TexelType::u8:
            return GL_UNSIGNED_BYTE;
        case TexelType::u16:
            return GL_UNSIGNED_SHORT;
        case TexelType::u32:
            return GL_UNSIGNED_INT;
        case TexelType::i8:
            return GL_BYTE;
        case TexelType::i16:
            return GL_SHORT;
        case TexelType::i32:
            return GL_INT;
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

GLenum glFormat(int components, TexelFormat format) {
    if (hasDepth(format)) return GL_DEPTH_COMPONENT;
    if (!isInteger(format)) return glFormat(components);
    switch (components) {
        case 1:
            return GL_RED_INTEGER;
        case 2:
            return GL_RG_INTEGER;
        case 3:
            return GL_RGB_INTEGER;
        default:
            return GL_RGBA_INTEGER;
    }
}

}  // namespace glibra::gpu
