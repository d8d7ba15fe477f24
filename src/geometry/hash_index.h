#pragma once
// An open-addressed table from keys kept elsewhere to the numbers 0, 1, 2 ... in order of first appearance.

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Mixes 64 bits ("splitmix64": Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014).
constexpr std::uint64_t spread(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xbf58476d1ce4e5b9U;
    x ^= x >> 27;
    x *= 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// The table holds only numbers; the caller keeps the keys and compares them.
class HashIndex {
  public:
    /// Makes a table for at most `most` different keys.
    explicit HashIndex(std::size_t most) : slots_(std::bit_ceil(most + most / 2 + 2), kNoIndex) {}

    /// Returns the number entered with that hash for which isKey(number) is true. If there is none, enters
    /// `next` and returns it.
    template <class IsKey>
    std::uint32_t findOrEnter(std::uint64_t hash, std::uint32_t next, IsKey isKey) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = static_cast<std::size_t>(hash) & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == kNoIndex) return slots_[slot] = next;
            if (isKey(slots_[slot])) return slots_[slot];
        }
    }

  private:
    std::vector<std::uint32_t> slots_;
};

}  // namespace glibra::geometry
