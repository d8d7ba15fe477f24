#pragma once
// Contrast of colours as WCAG 2.1 defines it.

#include <algorithm>
#include <cmath>

#include "view/style/palette.h"

namespace glibra::view {

/// Relative luminance (WCAG 2.1).
inline double luminance(const Color& color) {
    const auto linear = [](float component) {
        const auto c = static_cast<double>(component);
        return c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4);
    };
    return .2126 * linear(color.r) + .7152 * linear(color.g) + .0722 * linear(color.b);
}

/// The contrast ratio of WCAG 2.1 (1.4.3), 1 to 21.
inline double contrast(const Color& a, const Color& b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + .05) / (darker + .05);
}
inline constexpr double kReadable = 4.5;  ///< contrast that WCAG 2.1 (1.4.3) demands for text of this size

}  // namespace glibra::view
