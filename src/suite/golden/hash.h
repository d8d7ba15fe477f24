#pragma once
// Hashes of pixels and files: XXH3 with 128 bits (Yann Collet). They are not cryptographic: somebody can make
// two files with one hash on purpose.

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

/// Hash of the size, the component count, the component type and all pixels. It is the same on all machines
/// with the same byte order.
Hash hashOf(const image::Image& picture);
/// Hash of the bytes of a file.
Hash hashOf(std::span<const std::byte> bytes);

/// 32 hexadecimal digits, and back.
std::string toText(const Hash& hash);
std::optional<Hash> parseHash(std::string_view text);

}  // namespace glibra::suite
