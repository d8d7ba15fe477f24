#include "noise/checksum.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace glibra::noise {
namespace {

// 2^64 / golden ratio, made odd: multiplying by it spreads every bit over the upper half of the word.
constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15U;

std::uint64_t absorb(std::uint64_t lane, std::uint64_t word) {
    return std::rotl((lane ^ word) * kSpread, 29);
}

std::uint64_t wordAt(const std::uint8_t* from) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, sizeof word);
    return word;
}

}  // namespace

std::uint64_t checksum(std::span<const std::uint8_t> bytes, std::uint64_t seed) {
    std::array<std::uint64_t, 4> lanes{seed + 1, seed + 2, seed + 3, seed + 4};
    std::size_t at = 0;
    for (; at + 32 <= bytes.size(); at += 32)
        for (std::size_t lane = 0; lane < 4; ++lane)
            lanes[lane] = absorb(lanes[lane], wordAt(bytes.data() + at + 8 * lane));
    for (; at < bytes.size(); ++at) lanes[at % 4] = absorb(lanes[at % 4], bytes[at]);

    std::uint64_t sum = bytes.size();
    for (const std::uint64_t lane : lanes) sum = absorb(sum, lane);
    sum ^= sum >> 32;
    sum *= kSpread;
    return sum ^ (sum >> 32);
}

}  // namespace glibra::noise
