#include "gpu/format/pixel_format.h"

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "gpu/context/es_functions.h"

namespace glibra::gpu {
namespace {

/// GL's numbers: the internal format, and the layout in memory that loses nothing.
struct GlRow {
    GLenum internal, transferFormat, transferType;
};

constexpr std::array<GlRow, base::kTexelFormatCount> kRows{{
#define GLIBRA_TEXEL_FORMAT(name, kind, components, bytes, bits, ...) {__VA_ARGS__},
#include "base/texel_formats.def"
#undef GLIBRA_TEXEL_FORMAT
}};

const GlRow& glRowOf(TexelFormat format) {
    return kRows.at(static_cast<std::size_t>(format));
}

/// The driver's answers about textures of a format. Each is asked for once, since every target needs some.
class FormatAnswers {
  public:
    FormatAnswers(const Capabilities& capabilities, TexelFormat format)
        : known_(answers()[{capabilities.renderer, capabilities.version, format}]), format_(format) {}

    /// The answer for that use; GL_NONE for no.
    GLint operator()(GLenum target, GLenum what) {
        const auto [answer, isNew] = known_.try_emplace({target, what}, GL_NONE);
        if (isNew) glGetInternalformativ(target, internalFormat(format_), what, 1, &answer->second);
        return answer->second;
    }

  private:
    using OfFormat = std::map<std::pair<GLenum, GLenum>, GLint>;
    using OfDrivers = std::map<std::tuple<std::string, std::string, TexelFormat>, OfFormat>;
    static OfDrivers& answers() {
        thread_local OfDrivers all;
        return all;
    }

    OfFormat& known_;
    TexelFormat format_;
};

/// What every driver of GL 4.1 or 4.2 supports (OpenGL 4.2 core, 3.8.1 and table 3.21).
FormatUse guaranteedUse(const Capabilities& capabilities, TexelFormat format) {
    const base::TexelFormatRow& row = rowOf(format);
    FormatUse use;
    use.depth = hasDepth(format);
    use.stencil = hasStencil(format);
    use.color = !use.depth && row.kind != base::TexelClass::signedNormalized;
    use.filter = !isInteger(format);
    use.blend = use.color && !isInteger(format);
    use.image = capabilities.imageUnits > 0 && isImageFormat(format);
    if (use.color || use.depth)
        use.samples = isInteger(format) ? capabilities.maxIntegerSamples : capabilities.maxSamples;
    return use;
}

/// In OpenGL ES, which may have no normalized texels of 16 bits.
bool isStoredAsFloats(TexelFormat format) {
    const base::TexelFormatRow& row = rowOf(format);
    return isEs() && !hasWideTexels() && row.bits == 16 &&
           (row.kind == base::TexelClass::normalized || row.kind == base::TexelClass::signedNormalized);
}
constexpr std::array<GLenum, 5> kFloats{GL_NONE, GL_R32F, GL_RG32F, GL_NONE, GL_RGBA32F};

}  // namespace

GLenum internalFormat(TexelFormat format) {
    if (isStoredAsFloats(format)) return kFloats.at(rowOf(format).components);
    return glRowOf(format).internal;
}

Transfer nativeTransfer(TexelFormat format) {
    // OpenGL ES takes floats of all sizes with 32 bits.
    if (isStoredAsFloats(format) || (isEs() && isFloat(format)))
        return {glFormat(rowOf(format).components), GL_FLOAT};
    return {glRowOf(format).transferFormat, glRowOf(format).transferType};
}

FormatUse useOf(const Capabilities& capabilities, TexelFormat format) {
    FormatUse use = guaranteedUse(capabilities, format);
    if (!capabilities.atLeast(4, 3)) return use;
    FormatAnswers ask(capabilities, format);
    use.color = ask(GL_TEXTURE_2D, GL_COLOR_RENDERABLE) == GL_TRUE &&
                ask(GL_TEXTURE_2D, GL_FRAMEBUFFER_RENDERABLE) != GL_NONE;
    use.depth = use.depth && ask(GL_TEXTURE_2D, GL_DEPTH_RENDERABLE) == GL_TRUE &&
                ask(GL_TEXTURE_2D, GL_FRAMEBUFFER_RENDERABLE) != GL_NONE;
    use.stencil = use.stencil && use.depth && ask(GL_TEXTURE_2D, GL_STENCIL_RENDERABLE) == GL_TRUE;
    use.filter = use.filter && ask(GL_TEXTURE_2D, GL_FILTER) != GL_NONE;
    use.blend = use.color && !isInteger(format) && ask(GL_TEXTURE_2D, GL_FRAMEBUFFER_BLEND) != GL_NONE;
    use.image = use.image && ask(GL_TEXTURE_2D, GL_SHADER_IMAGE_LOAD) != GL_NONE &&
                ask(GL_TEXTURE_2D, GL_SHADER_IMAGE_STORE) != GL_NONE;
    use.samples = 0;
    // GL_SAMPLES lists the numbers of samples in descending order.
    if ((use.color || use.depth) && ask(GL_TEXTURE_2D_MULTISAMPLE, GL_NUM_SAMPLE_COUNTS) > 0)
        use.samples = ask(GL_TEXTURE_2D_MULTISAMPLE, GL_SAMPLES);
    return use;
}

GLenum glType(TexelType type) {
    constexpr std::array<GLenum, 7> kTexelTypes{
        GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT, GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT};
    return kTexelTypes.at(static_cast<std::size_t>(type));
}

GLenum glFormat(int components) {
    constexpr std::array<GLenum, 4> kFormats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
    return kFormats.at(static_cast<std::size_t>(components) - 1);
}

GLenum glFormat(int components, TexelFormat format) {
    constexpr std::array<GLenum, 4> kIntegers{GL_RED_INTEGER, GL_RG_INTEGER, GL_RGB_INTEGER, GL_RGBA_INTEGER};
    if (hasDepth(format)) return GL_DEPTH_COMPONENT;
    return isInteger(format) ? kIntegers.at(static_cast<std::size_t>(components) - 1) : glFormat(components);
}

}  // namespace glibra::gpu
