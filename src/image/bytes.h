#pragma once
// Numbers in bytes: in the machine's order, and in an order of their own, byte by byte.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>
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

inline std::string_view charactersOf(ByteSpan bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Big-endian, as in PNG.
inline void putBig32(std::vector<std::byte>& to, std::uint32_t value) {
    for (unsigned shift = 32; shift > 0; shift -= 8)
        to.push_back(static_cast<std::byte>(value >> (shift - 8)));
}

/// One component of a pixel that is packed into an integer: that in the bits of `mask`, scaled to the whole
/// range of Value with rounding. A component without a mask is `missing`.
template <class Value>
class BitField {
  public:
    BitField(std::uint32_t mask, Value missing)
        : mask_(mask),
          shift_(mask == 0 ? 0 : static_cast<std::uint32_t>(std::countr_zero(mask))),
          missing_(missing),
          most_(mask >> shift_) {}

    [[nodiscard]] Value of(std::uint32_t pixel) const {
        if (mask_ == 0) return missing_;
        const std::uint64_t value = (pixel & mask_) >> shift_;
        return static_cast<Value>((value * std::numeric_limits<Value>::max() + most_ / 2) / most_);
    }

  private:
    std::uint32_t mask_, shift_;
    Value missing_;
    std::uint64_t most_;
};

}  // namespace glibra::image
