#include "base/texel_format.h"

#include "base/text.h"

namespace glibra::base {
namespace {

using enum TexelClass;

constexpr std::array<TexelFormatRow, kTexelFormatCount> kRows{{
#define GLIBRA_TEXEL_FORMAT(name, kind, components, bytes, bits, ...) \
    {TexelFormat::name, #name, kind, components, bytes, bits},
#include "base/texel_formats.def"
#undef GLIBRA_TEXEL_FORMAT
}};

}  // namespace

std::span<const TexelFormatRow, kTexelFormatCount> texelFormats() {
    return kRows;
}

const TexelFormatRow& rowOf(TexelFormat format) {
    return kRows.at(static_cast<std::size_t>(format));
}

std::optional<TexelFormat> texelFormatNamed(std::string_view name) {
    for (const TexelFormatRow& row : kRows)
        if (sameWord(row.name, name)) return row.format;
    return std::nullopt;
}

}  // namespace glibra::base
