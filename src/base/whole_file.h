#pragma once
// The whole content of files that were opened by the functions of contained.h.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/contained.h"

namespace glibra::base {

/// The content of an open file of at most `largest` bytes. Nothing if it is not open or cannot be read.
std::optional<std::vector<std::byte>> bytesIn(const Descriptor& file, std::uint64_t largest);
/// The same as text, which may have any bytes.
std::optional<std::string> textIn(const Descriptor& file, std::uint64_t largest);

/// The bytes as text.
inline std::string_view asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace glibra::base
