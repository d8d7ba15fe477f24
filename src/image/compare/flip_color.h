#pragma once
// The pixelwise steps of FLIP, over rows of planes, so that the compiler vectorises them.

#include <cstddef>

namespace glibra::image {

/// The linear value of an sRGB value in 0..1 (IEC 61966-2-1).
float linearOf(float srgb);

/// Linear RGB in 0..1 to YCxCz, in place: an opponent space, linear in XYZ (D65), with the scale of L*a*b*.
void toOpponent(float* r, float* g, float* b, std::size_t count);

/// Filtered planes of one row of one picture.
struct FilteredRow {
    const float *y, *cx, *cz1, *cz2;   ///< contrast sensitivity; Cz is the sum of two
    const float *dx, *dy, *ddx, *ddy;  ///< first and second derivatives of the achromatic plane
};

/// The final error of each pixel, 0..1. `count` is a multiple of 8.
void flipErrors(const FilteredRow& reference, const FilteredRow& test, std::size_t count, float* errors);

}  // namespace glibra::image
