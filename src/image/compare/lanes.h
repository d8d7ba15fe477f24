#pragma once
// Four floats that are computed together, with the vector types of GCC and Clang. The operations are those of
// scalar code, so the results have the same bits.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace glibra::image {

inline constexpr std::size_t kLanes = 4;
using Lanes [[gnu::vector_size(16)]] = float;
using IntLanes [[gnu::vector_size(16)]] = std::int32_t;

inline Lanes loadLanes(const float* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

inline void store(Lanes lanes, float* to) {
    std::memcpy(to, &lanes, sizeof lanes);
}

inline Lanes allLanes(float value) {
    return Lanes{value, value, value, value};
}

inline Lanes larger(Lanes a, Lanes b) {
    return a > b ? a : b;
}

inline Lanes smaller(Lanes a, Lanes b) {
    return a < b ? a : b;
}

inline Lanes absolute(Lanes a) {
    return std::bit_cast<Lanes>(std::bit_cast<IntLanes>(a) & 0x7fffffff);
}

inline Lanes squareRoot(Lanes a) {
    return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}

}  // namespace glibra::image
