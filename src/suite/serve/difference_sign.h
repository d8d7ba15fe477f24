#pragma once
// How two pictures differ, in so few numbers that alike differences of other pictures can be found.

#include <array>
#include <optional>
#include <string>

#include "image/image.h"

namespace glibra::suite {

struct DifferenceSign {
    std::array<double, 3> color{};  ///< mean signed difference of the pixels that differ, in 255ths
    double size = 0;                ///< mean absolute difference of the pixels that differ, in 255ths
    double share = 0;               ///< of the pixels that differ
};

/// The sign of the difference of two pictures; nothing if they have different sizes or do not differ.
std::optional<DifferenceSign> differenceSign(const image::Image& expected, const image::Image& got);
/// True if somebody who has judged the one knows what to expect of the other: the colours change in the same
/// direction, and size and share of the change are alike within a factor of two.
bool areAlike(const DifferenceSign& a, const DifferenceSign& b);
/// "12 of 255 darker in 38 % of the pixels".
std::string toText(const DifferenceSign& sign);

}  // namespace glibra::suite
