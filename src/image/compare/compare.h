#pragma once
// The difference of two pictures in plain numbers.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// Differences are in units of the full range: 1/255 is one step of an 8-bit picture. Pictures with different
/// component counts or types are compared as RGBA of the wider type, so an opaque RGBA picture equals the RGB
/// one. NaN at the same place in both is not a difference, but it is counted in `nonFinite`. NaN against a
/// number, and an infinity against anything but itself, is an infinite difference.
struct Comparison {
    bool sameSize =
        true;  ///< if false, the pictures were not compared: identical is false, the numbers are 0
    bool identical = true;  ///< all values are equal
    std::uint64_t differingPixels = 0;
    double largest = 0;           ///< infinite if one value is NaN and the other is not
    int x = 0, y = 0;             ///< place of the first largest difference, from the top left
    int component = 0;            ///< 0..3: red, green, blue, alpha (or grey, alpha)
    double rootMeanSquare = 0;    ///< over all components of all pixels
    std::uint64_t nonFinite = 0;  ///< components that are NaN or infinite in either picture
};

Comparison compare(const Image& a, const Image& b);

}  // namespace glibra::image
