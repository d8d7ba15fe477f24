#pragma once
// A picture of the differences of two pictures: black means no difference, then violet, red, yellow, and
// almost white for the largest.

#include "image/compare/flip.h"
#include "image/image.h"

namespace glibra::image {

/// The colour of a value in 0..1 (NaN and infinity as 1) on the scale "magma" by Stefan van der Walt and
/// Nathaniel Smith (matplotlib), whose steps look equally large to the eye: sRGB, 0..1. Computed with the
/// polynomials of degree 6 that Matt Zucker fitted to it ("Polynomial fits to colormaps", 2019, public
/// domain), within 0.02 of the table.
void magma(double value, double& red, double& green, double& blue);

/// RGB, 8 bits: the largest difference of the components of each pixel, on a logarithmic scale, so that one
/// step of 8 bits is visible beside a difference of the whole range: log2(1 + d) / 8 for d 255ths.
/// Differences of float values beyond the range look like the whole range. An empty picture if the sizes
/// differ.
Image differenceHeatMap(const Image& expected, const Image& got);

/// RGB, 8 bits: the errors of FLIP, 0..1.
Image flipHeatMap(const FlipResult& result);

}  // namespace glibra::image
