#pragma once
// Where two pictures differ, and how much, as a picture: black is no difference, then violet, red, yellow,
// almost white the largest.

#include "image/compare/flip.h"
#include "image/image.h"

namespace glibra::image {

/// The color of a value in 0..1 (NaN and infinity as 1) on the scale "magma" by Stefan van der Walt and
/// Nathaniel Smith (matplotlib), whose steps look equally large to the eye: sRGB, 0..1. By the polynomials of
/// degree 6 that Matt Zucker fitted to it ("Polynomial fits to colormaps", 2019, public domain); within 0.02
/// of the table.
void magma(double value, double& red, double& green, double& blue);

/// RGB, 8 bits, of the largest difference of a pixel's components, on a logarithmic scale, so that one step
/// of 8 bits can be seen beside a difference of the whole range: log2(1 + d) / 8 for d 255ths. Float values
/// may differ by more than the range, which looks the same as all of it. An empty picture if the sizes
/// differ.
Image differenceHeatMap(const Image& expected, const Image& got);

/// RGB, 8 bits, of FLIP's errors, 0..1.
Image flipHeatMap(const FlipResult& result);

}  // namespace glibra::image
