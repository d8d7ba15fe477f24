#pragma once
// How alike the statistics of two patterns are, which tells random ones apart: clouds, marble, stains.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "classroom/tone_scales.h"

namespace glibra::classroom {

/// Kinds of places: flat, slope, dark and light blob, dark and light line, saddle.
inline constexpr std::size_t kPlaceKinds = 7;

/// The shares of pixels that are of one kind in a scale and of another in the scale that is twice as coarse;
/// nothing for a scale in which too few pixels are known.
using KindShares = std::array<double, kPlaceKinds * kPlaceKinds>;
struct PatternKinds {
    std::vector<std::optional<KindShares>> scales;
};

/// Each place is of the kind whose response is the largest (M. Crosier, L. Griffin: "Using Basic Image
/// Features for Texture Classification", IJCV 2010). Neither a turn nor contrast changes that.
PatternKinds patternKindsOf(const ToneScales& tones);

/// The Bhattacharyya coefficient of the shares, from 0 to 1, at the best change of scale (by up to four,
/// which costs a little), and with dark and light exchanged if that fits better.
double commonKinds(const PatternKinds& a, const PatternKinds& b);

}  // namespace glibra::classroom
