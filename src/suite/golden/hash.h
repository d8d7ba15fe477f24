#pragma once
// Exact identity of pixels and of files: XXH3, 128 bits (Yann Collet). It tells pictures apart, it does not
// withstand anybody who wants two to collide.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/image.h"

namespace glibra::suite {

struct Hash {
    std::uint64_t high = 0, low = 0;
    friend bool operator==(const Hash&, const Hash&) = default;
};

/// Of the size, the component count, the component type and all pixels: equal for equal pictures only, on
/// every machine of the same byte order.
Hash hashOf(const image::Image& picture);
/// Of a file's bytes.
Hash hashOf(std::span<const std::byte> bytes);

/// 32 hexadecimal digits, and back.
std::string toText(const Hash& hash);
std::optional<Hash> parseHash(std::string_view text);

}  // namespace glibra::suite
