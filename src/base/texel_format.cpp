#include "base/texel_format.h"

#include <algorithm>

namespace glibra::base {
namespace {

using enum TexelClass;

constexpr std::array<TexelFormatRow, kTexelFormatCount> kRows{{
    {TexelFormat::r8, "r8", normalized, 1, 1},
    {TexelFormat::rg8, "rg8", normalized, 2, 2},
    {TexelFormat::rgba8, "rgba8", normalized, 4, 4},
    {TexelFormat::r16, "r16", normalized, 1, 2},
    {TexelFormat::rg16, "rg16", normalized, 2, 4},
    {TexelFormat::rgba16, "rgba16", normalized, 4, 8},
    {TexelFormat::r8_snorm, "r8_snorm", signedNormalized, 1, 1},
    {TexelFormat::rg8_snorm, "rg8_snorm", signedNormalized, 2, 2},
    {TexelFormat::rgba8_snorm, "rgba8_snorm", signedNormalized, 4, 4},
    {TexelFormat::r16_snorm, "r16_snorm", signedNormalized, 1, 2},
    {TexelFormat::rg16_snorm, "rg16_snorm", signedNormalized, 2, 4},
    {TexelFormat::rgba16_snorm, "rgba16_snorm", signedNormalized, 4, 8},
    {TexelFormat::r16f, "r16f", floating, 1, 2},
    {TexelFormat::rg16f, "rg16f", floating, 2, 4},
    {TexelFormat::rgba16f, "rgba16f", floating, 4, 8},
    {TexelFormat::r32f, "r32f", floating, 1, 4},
    {TexelFormat::rg32f, "rg32f", floating, 2, 8},
    {TexelFormat::rgba32f, "rgba32f", floating, 4, 16},
    {TexelFormat::r8i, "r8i", integer, 1, 1},
    {TexelFormat::rg8i, "rg8i", integer, 2, 2},
    {TexelFormat::rgba8i, "rgba8i", integer, 4, 4},
    {TexelFormat::r16i, "r16i", integer, 1, 2},
    {TexelFormat::rg16i, "rg16i", integer, 2, 4},
    {TexelFormat::rgba16i, "rgba16i", integer, 4, 8},
    {TexelFormat::r32i, "r32i", integer, 1, 4},
    {TexelFormat::rg32i, "rg32i", integer, 2, 8},
    {TexelFormat::rgba32i, "rgba32i", integer, 4, 16},
    {TexelFormat::r8ui, "r8ui", unsignedInteger, 1, 1},
    {TexelFormat::rg8ui, "rg8ui", unsignedInteger, 2, 2},
    {TexelFormat::rgba8ui, "rgba8ui", unsignedInteger, 4, 4},
    {TexelFormat::r16ui, "r16ui", unsignedInteger, 1, 2},
    {TexelFormat::rg16ui, "rg16ui", unsignedInteger, 2, 4},
    {TexelFormat::rgba16ui, "rgba16ui", unsignedInteger, 4, 8},
    {TexelFormat::r32ui, "r32ui", unsignedInteger, 1, 4},
    {TexelFormat::rg32ui, "rg32ui", unsignedInteger, 2, 8},
    {TexelFormat::rgba32ui, "rgba32ui", unsignedInteger, 4, 16},
    {TexelFormat::srgb8_alpha8, "srgb8_alpha8", normalized, 4, 4},
    {TexelFormat::r11f_g11f_b10f, "r11f_g11f_b10f", floating, 3, 4},
    {TexelFormat::rgb10_a2, "rgb10_a2", normalized, 4, 4},
    {TexelFormat::depth16, "depth16", depth, 1, 2},
    {TexelFormat::depth24, "depth24", depth, 1, 4},
    {TexelFormat::depth32f, "depth32f", depth, 1, 4},
    {TexelFormat::depth24_stencil8, "depth24_stencil8", depthStencil, 2, 4},
    {TexelFormat::depth32f_stencil8, "depth32f_stencil8", depthStencil, 2, 8},
}};

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kRows.size(); ++i)
        if (static_cast<std::size_t>(kRows[i].format) != i) return false;
    return true;
}
static_assert(isInOrder());

constexpr char lowered(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::span<const TexelFormatRow, kTexelFormatCount> texelFormats() {
    return kRows;
}

const TexelFormatRow& rowOf(TexelFormat format) {
    return kRows.at(static_cast<std::size_t>(format));
}

std::optional<TexelFormat> texelFormatNamed(std::string_view name) {
    for (const TexelFormatRow& row : kRows)
        if (std::equal(row.name.begin(), row.name.end(), name.begin(), name.end(),
                       [](char a, char b) { return a == lowered(b); }))
            return row.format;
    return std::nullopt;
}

}  // namespace glibra::base
