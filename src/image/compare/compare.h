#pragma once
// The differences of two pictures: in plain numbers, of their structure, and as pictures.

#include <cstdint>

#include "image/compare/flip.h"
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
    double rootMeanSquare = 0;    ///< over all components of all pixels, but an alpha of 1
    std::uint64_t nonFinite = 0;  ///< components that are NaN or infinite in either picture
};

Comparison compare(const Image& a, const Image& b);

// Compares the structure of two pictures: edges may move by one pixel, as between the rasterisers of
// different drivers, but shapes that are missing, added or changed count. FLIP reports both.

struct StructureResult {
    double difference = 0;  ///< 0: the same structure; 1: nothing in common in some block
    int x = 0, y = 0;       ///< top left pixel of the block that differs most
    int width = 0, height = 0;
};

/// The idea comes from VTK's regression tests (SSIM after Wang, Bovik, Sheikh, Simoncelli: "Image Quality
/// Assessment", IEEE Transactions on Image Processing 13(4), 2004, and a search of the eight neighbours),
/// with a result that does not depend on the size of the picture.
///
/// Windows have 4 x 4 pixels and start every 2 pixels; they are small so that the pieces of a thin line may
/// move independently. The window of the second picture is tried at nine places, up to one pixel away in x
/// and y. At each place the loss of a component is the larger of
///   1 - (2 covariance + c) / (variance + variance + c), c = (0.03 * 255)^2: SSIM's contrast and structure,
///   (difference of the means / (16 / 255))^2: SSIM's own term hardly sees a change of brightness,
/// limited to 0..1. The loss of a place is that of its worst component; the loss of a window is that of its
/// best place. `difference` is the largest mean loss over the windows of any block of 32 x 32 pixels (blocks
/// start every 16 pixels).
///
/// Alpha is a component like the others. Values are limited to 0..1. NaN equals NaN; against a number it has
/// the largest loss. Pictures of different sizes or without pixels differ by 1.
///
/// Typical values: 0 to 0.02 for edges that another driver draws elsewhere, 0.2 for a drawing of lines by a
/// driver with another rule for lines, 0.3 for a marble whose noise is 2 % stronger.
StructureResult structure(const Image& expected, const Image& got);

// A picture of the differences of two pictures: black means no difference, then violet, red, yellow, and
// almost white for the largest.

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
