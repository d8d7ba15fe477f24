#include "gpu/format/pixel_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <type_traits>
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

namespace {

/// 1 of a whole number that stands for a fraction.
double unitOf(TexelType type) {
    switch (type) {
        case TexelType::u8:
            return 255;
        case TexelType::i8:
            return 127;
        case TexelType::u16:
            return 65535;
        case TexelType::i16:
            return 32767;
        case TexelType::u32:
            return 4294967295.0;
        case TexelType::i32:
            return 2147483647;
        default:
            return 1;
    }
}

template <class T>
double loaded(const std::byte* at) {
    T value;
    std::copy_n(at, sizeof value, reinterpret_cast<std::byte*>(&value));
    return static_cast<double>(value);
}

double load(const std::byte* at, TexelType type) {
    switch (type) {
        case TexelType::u8:
            return loaded<std::uint8_t>(at);
        case TexelType::i8:
            return loaded<std::int8_t>(at);
        case TexelType::u16:
            return loaded<std::uint16_t>(at);
        case TexelType::i16:
            return loaded<std::int16_t>(at);
        case TexelType::u32:
            return loaded<std::uint32_t>(at);
        case TexelType::i32:
            return loaded<std::int32_t>(at);
        default:
            return static_cast<double>(loaded<float>(at));
    }
}

template <class T>
void stored(double value, std::byte* at) {
    if constexpr (std::is_integral_v<T>)
        value = std::clamp(std::nearbyint(value), static_cast<double>(std::numeric_limits<T>::min()),
                           static_cast<double>(std::numeric_limits<T>::max()));
    const auto as = static_cast<T>(value);
    std::copy_n(reinterpret_cast<const std::byte*>(&as), sizeof as, at);
}

void store(double value, TexelType type, std::byte* at) {
    switch (type) {
        case TexelType::u8:
            return stored<std::uint8_t>(value, at);
        case TexelType::i8:
            return stored<std::int8_t>(value, at);
        case TexelType::u16:
            return stored<std::uint16_t>(value, at);
        case TexelType::i16:
            return stored<std::int16_t>(value, at);
        case TexelType::u32:
            return stored<std::uint32_t>(value, at);
        case TexelType::i32:
            return stored<std::int32_t>(value, at);
        default:
            return stored<float>(value, at);
    }
}

}  // namespace

TexelType typeOf(GLenum type) {
    for (const TexelType each :
         {TexelType::u8, TexelType::u16, TexelType::u32, TexelType::i8, TexelType::i16, TexelType::i32})
        if (glType(each) == type) return each;
    return TexelType::f32;
}

std::vector<std::byte> converted(std::span<const std::byte> texels, TexelLayout from, TexelLayout to,
                                 bool isNormalized) {
    const std::size_t in = bytesOf(from.type), out = bytesOf(to.type);
    const auto have = static_cast<std::size_t>(from.components),
               want = static_cast<std::size_t>(to.components);
    const std::size_t count = texels.size() / (in * have);
    std::vector<std::byte> result(count * out * want);
    const double scale = isNormalized ? unitOf(to.type) / unitOf(from.type) : 1;
    const double one = isNormalized ? unitOf(to.type) : 1;
    const bool isSame = from.type == to.type;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < want; ++c) {
            std::byte* const at = result.data() + (i * want + c) * out;
            const std::byte* const source = texels.data() + (i * have + c) * in;
            if (c >= have)
                store(c == 3 ? one : 0, to.type, at);
            else if (isSame)
                std::copy_n(source, in, at);
            else
                store(load(source, from.type) * scale, to.type, at);
        }
    return result;
}

std::vector<std::byte> forEs(std::span<const std::byte> texels, TexelLayout layout, TexelFormat format) {
    const base::TexelFormatRow& row = base::rowOf(format);
    const Transfer transfer = nativeTransfer(format);
    const bool isFraction = !isInteger(format);
    if (format == TexelFormat::rgb10_a2) {
        const std::vector<std::byte> floats = converted(texels, layout, {4, TexelType::f32}, true);
        std::vector<std::byte> result(floats.size() / 4);
        for (std::size_t i = 0; i < result.size() / 4; ++i) {
            const auto bits = [&](std::size_t c, double most) {
                const double value =
                    std::clamp(load(floats.data() + (i * 4 + c) * 4, TexelType::f32), 0.0, 1.0);
                return static_cast<std::uint32_t>(std::nearbyint(value * most));
            };
            const std::uint32_t packed =
                bits(0, 1023) | bits(1, 1023) << 10U | bits(2, 1023) << 20U | bits(3, 3) << 30U;
            std::copy_n(reinterpret_cast<const std::byte*>(&packed), 4, result.data() + i * 4);
        }
        return result;
    }
    return converted(texels, layout, {hasDepth(format) ? 1 : row.components, typeOf(transfer.type)},
                     isFraction);
}

}  // namespace glibra::gpu
