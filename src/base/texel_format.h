#pragma once
// The formats of textures and targets, as values without GL. `gpu` knows their GL numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace glibra::base {

/// A format on the device. The names are GL's, in lower case and without the prefix.
enum class TexelFormat : std::uint8_t {
    r8,
    rg8,
    rgba8,
    r16,
    rg16,
    rgba16,
    r8_snorm,
    rg8_snorm,
    rgba8_snorm,
    r16_snorm,
    rg16_snorm,
    rgba16_snorm,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r8i,
    rg8i,
    rgba8i,
    r16i,
    rg16i,
    rgba16i,
    r32i,
    rg32i,
    rgba32i,
    r8ui,
    rg8ui,
    rgba8ui,
    r16ui,
    rg16ui,
    rgba16ui,
    r32ui,
    rg32ui,
    rgba32ui,
    srgb8_alpha8,
    r11f_g11f_b10f,
    rgb10_a2,
    depth16,
    depth24,
    depth32f,
    depth24_stencil8,
    depth32f_stencil8,
};
inline constexpr std::size_t kTexelFormatCount = static_cast<std::size_t>(TexelFormat::depth32f_stencil8) + 1;

/// What a shader reads from a texel.
enum class TexelClass : std::uint8_t {
    normalized,        ///< 0..1
    signedNormalized,  ///< -1..1
    floating,
    integer,
    unsignedInteger,
    depth,
    depthStencil,
};

/// One row of the table of formats.
struct TexelFormatRow {
    TexelFormat format{};
    std::string_view name;  ///< as scenes write it, and the format word of a GLSL image
    TexelClass kind{};
    std::uint8_t components = 4;
    std::uint8_t bytes = 4;  ///< per texel, with the padding of depth32f_stencil8
};

/// All formats in the order of TexelFormat.
std::span<const TexelFormatRow, kTexelFormatCount> texelFormats();
const TexelFormatRow& rowOf(TexelFormat format);
/// The format with that name in any case; nothing if there is none.
std::optional<TexelFormat> texelFormatNamed(std::string_view name);

inline std::string_view name(TexelFormat format) {
    return rowOf(format).name;
}
inline std::size_t bytesPerTexel(TexelFormat format) {
    return rowOf(format).bytes;
}
/// True if the format keeps values outside -1..1.
inline bool isFloat(TexelFormat format) {
    return rowOf(format).kind == TexelClass::floating;
}
/// True if shaders read the texels as integers: isampler and usampler.
inline bool isInteger(TexelFormat format) {
    const TexelClass kind = rowOf(format).kind;
    return kind == TexelClass::integer || kind == TexelClass::unsignedInteger;
}
inline bool hasDepth(TexelFormat format) {
    return rowOf(format).kind >= TexelClass::depth;
}
inline bool hasStencil(TexelFormat format) {
    return rowOf(format).kind == TexelClass::depthStencil;
}

}  // namespace glibra::base
