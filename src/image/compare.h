#pragma once
// How two pictures differ, in plain numbers.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// Differences are in units of the full range: 1/255 is one step of an 8-bit picture. Pictures of different
/// component count or type are compared as RGBA of the wider type, so an opaque RGBA picture equals the RGB
/// one.
struct Comparison {
    bool sameSize = true;   ///< if false, nothing was compared: identical is false, the numbers are 0
    bool identical = true;  ///< all values are equal
    std::uint64_t differingPixels = 0;
    double largest = 0;         ///< infinite where one value is NaN and the other is not
    int x = 0, y = 0;           ///< of the first largest difference, counted from the top left
    int component = 0;          ///< 0..3: red, green, blue, alpha (or grey, alpha)
    double rootMeanSquare = 0;  ///< over all components of all pixels
};

Comparison compare(const Image& a, const Image& b);

}  // namespace glibra::image
