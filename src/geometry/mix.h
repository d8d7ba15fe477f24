#pragma once
// The counter-based hash behind everything random in a shape.

#include <cstdint>

namespace glibra::geometry {

/// A bijection of 32 bits in which every input bit flips every output bit about half of the time
/// ("lowbias32": Chris Wellons, Prospecting for Hash Functions, 2018).
constexpr std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    x ^= x >> 16;
    return x;
}

}  // namespace glibra::geometry
