#pragma once
// A 64-bit checksum that finds damage, at memory speed: four independent lanes of multiply and rotate over
// 8-byte words. It is no protection against intent.

#include <cstdint>
#include <span>

namespace glibra::noise {

std::uint64_t checksum(std::span<const std::uint8_t> bytes, std::uint64_t seed = 0);

}  // namespace glibra::noise
