#pragma once
// Two pictures of equal size in the same components and type, without a copy if they already match.

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "image/convert.h"
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

}  // namespace glibra::image
