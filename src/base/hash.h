#pragma once
// Hashes. Only SHA-256 is cryptographic: of the others somebody can make two texts with one hash on purpose.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace glibra::base {

/// Where others compute the same numbers: FNV-1a with 64 bits (Fowler, Noll, Vo). `hash`: of what stands
/// before the bytes.
constexpr std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xcbf29ce484222325U) {
    for (const char each : bytes) hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001b3U;
    return hash;
}

/// A bijection of 64 bits: the finaliser of MurmurHash3 (Appleby).
constexpr std::uint64_t murmurMixed(std::uint64_t h) {
    h = (h ^ (h >> 33U)) * 0xff51afd7ed558ccdU;
    h = (h ^ (h >> 33U)) * 0xc4ceb9fe1a85ec53U;
    return h ^ (h >> 33U);
}

/// The increment of splitmix64: 2^64 divided by the golden ratio.
inline constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;
/// A bijection of 64 bits: the finaliser of splitmix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom
/// Number Generators, 2014).
constexpr std::uint64_t splitMixed(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// The hash of what stands before, and a value.
constexpr std::uint64_t combined(std::uint64_t hash, std::uint64_t value) {
    return splitMixed(hash + kGolden + value);
}

/// XXH3 with 128 bits (Yann Collet), for pixels and files.
struct Hash {
    std::uint64_t high = 0, low = 0;
    friend bool operator==(const Hash&, const Hash&) = default;
};
/// Of these bytes, one part after another.
Hash hashOf(std::initializer_list<std::span<const std::byte>> parts);

/// SHA-256 (FIPS 180-4): by it a Content-Security-Policy names the scripts that may run, and Git LFS the
/// content of a file.
std::array<std::byte, 32> sha256(std::span<const std::byte> bytes);
/// The same as 64 hexadecimal digits.
std::string sha256Text(std::span<const std::byte> bytes);

}  // namespace glibra::base
