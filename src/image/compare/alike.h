#pragma once
// Converts two pictures of equal size to the same components and type, without a copy if they already match.

#include <algorithm>
#include <type_traits>

#include "image/convert.h"
#include "image/image.h"

namespace glibra::image {

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

}  // namespace glibra::image
