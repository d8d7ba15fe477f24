#pragma once
// The formats of textures and targets, as values without GL. `gpu` knows their GL numbers.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

namespace glibra::base {

/// A format on the device. The names are GL's, in lower case and without the prefix.
enum class TexelFormat : std::uint8_t {
#define GLIBRA_TEXEL_FORMAT(name, ...) name,
#include "base/texel_formats.def"
#undef GLIBRA_TEXEL_FORMAT
};
inline constexpr TexelFormat kEveryTexelFormat[] = {
#define GLIBRA_TEXEL_FORMAT(name, ...) TexelFormat::name,
#include "base/texel_formats.def"
#undef GLIBRA_TEXEL_FORMAT
};
inline constexpr std::size_t kTexelFormatCount = std::size(kEveryTexelFormat);

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
    std::uint8_t bits = 8;   ///< of a component with equal steps (alpha may have fewer); 0: floats
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
/// True if shaders can have images of that format (ARB_shader_image_load_store, table X.2).
inline bool isImageFormat(TexelFormat format) {
    return !hasDepth(format) && format != TexelFormat::srgb8_alpha8;
}
inline bool hasStencil(TexelFormat format) {
    return rowOf(format).kind == TexelClass::depthStencil;
}

}  // namespace glibra::base
