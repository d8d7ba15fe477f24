#pragma once
// What the comparisons share: pictures in the same components and type, and four floats at a time.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/image.h"

namespace glibra::image {

/// True for pictures of equal size that have pixels.
inline bool areComparable(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && isConsistent(a) && isConsistent(b);
}

/// Calls use(a, b) with pictures of equal component count and type: RGBA if the counts differ, the wider type
/// if the types differ. Both must be consistent.
template <class Use>
std::invoke_result_t<Use, const Image&, const Image&> withAlike(const Image& a, const Image& b, Use use) {
    if (a.components != b.components && a.components != 4) return withAlike(withComponents(a, 4), b, use);
    if (a.components != b.components) return withAlike(a, withComponents(b, 4), use);
    const Component wider = std::max(a.type, b.type);
    if (a.type != wider) return use(withType(a, wider), b);
    if (b.type != wider) return use(a, withType(b, wider));
    return use(a, b);
}

/// How far two values are apart. NaN equals NaN, and is infinitely far from a number.
inline double apart(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (std::isnan(a) || std::isnan(b)) return std::numeric_limits<double>::infinity();
    return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

// Four floats that are computed together, with the vector types of GCC and Clang. The operations are those of
// scalar code, so the results have the same bits.

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
