#pragma once
// Hashes of pixels and files, and their texts.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/hash.h"
#include "image/image.h"

namespace glibra::suite {

using base::Hash;

/// Hash of the size, the component count, the component type and all pixels. It is the same on all machines
/// with the same byte order.
Hash hashOf(const image::Image& picture);
/// Hash of the bytes of a file.
Hash hashOf(std::span<const std::byte> bytes);

/// 32 hexadecimal digits, and back.
std::string toText(const Hash& hash);
std::optional<Hash> parseHash(std::string_view text);

}  // namespace glibra::suite
