#pragma once
// Numbers in bytes: in the machine's order, and in an order of their own, byte by byte.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace glibra::image {

using ByteSpan = std::span<const std::byte>;

/// The number at an index of an array of numbers in the machine's order, with any alignment.
template <class Value>
Value valueAt(const std::byte* numbers, std::size_t index) {
    Value value;
    std::memcpy(&value, numbers + index * sizeof value, sizeof value);
    return value;
}

/// Little-endian. The bytes must exist.
inline std::uint32_t little16(std::span<const std::byte> bytes, std::size_t at) {
    return std::to_integer<std::uint32_t>(bytes[at]) | std::to_integer<std::uint32_t>(bytes[at + 1]) << 8U;
}
inline std::uint32_t little32(std::span<const std::byte> bytes, std::size_t at) {
    return little16(bytes, at) | little16(bytes, at + 2) << 16U;
}

/// Big-endian. The bytes must exist.
inline std::uint32_t big16(std::span<const std::byte> bytes, std::size_t at) {
    return std::to_integer<std::uint32_t>(bytes[at]) << 8U | std::to_integer<std::uint32_t>(bytes[at + 1]);
}
inline std::uint32_t big32(std::span<const std::byte> bytes, std::size_t at) {
    return big16(bytes, at) << 16U | big16(bytes, at + 2);
}
inline std::uint8_t octetAt(std::span<const std::byte> bytes, std::size_t at) {
    return std::to_integer<std::uint8_t>(bytes[at]);
}

/// Big-endian, as in PNG.
inline void putBig32(std::vector<std::byte>& to, std::uint32_t value) {
    for (unsigned shift = 32; shift > 0; shift -= 8)
        to.push_back(static_cast<std::byte>(value >> (shift - 8)));
}

}  // namespace glibra::image
