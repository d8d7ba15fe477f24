#pragma once
// Whether two pictures show the same structure: a measure that lets edges fall one pixel to the side, as
// other drivers' rasterizers make them, and sees what is missing, added or of another shape.

#include "image/image.h"

namespace glibra::image {

struct StructureResult {
    double difference = 0;  ///< 0: the same structure; 1: nothing in common in some block
    int x = 0, y = 0;       ///< top left pixel of the block that differs most
    int width = 0, height = 0;
};

/// The idea is that of VTK's regression tests (SSIM after Wang, Bovik, Sheikh, Simoncelli: "Image Quality
/// Assessment", IEEE Transactions on Image Processing 13(4), 2004, and the search of the eight neighbours),
/// with a figure that does not depend on the picture's size.
///
/// Windows of 4 x 4 pixels every 2 pixels (so small that a thin line's pieces may move by themselves). The
/// second picture's window is tried at nine places, up to one pixel away in x and y. At each place a
/// component loses the larger of
///   1 - (2 covariance + c) / (variance + variance + c), c = (0.03 * 255)^2: SSIM's contrast and structure,
///   (difference of the means / (16 / 255))^2: SSIM's own term hardly sees a change of brightness,
/// limited to 0..1. The worst component counts, then the best place. `difference` is the largest mean loss
/// over the windows of any block of 32 x 32 pixels (blocks lie 16 pixels apart).
///
/// Alpha is a component like the others. Values are limited to 0..1; NaN equals NaN and is so far from every
/// number that the window is lost. Pictures of different sizes or without pixels differ by 1.
///
/// For orientation: edges that other drivers draw elsewhere give 0 to 0.02, a driver with another rule for
/// lines 0.2 on a drawing of lines, a change of a marble's noise by 2 % of its strength 0.3.
StructureResult structure(const Image& expected, const Image& got);

}  // namespace glibra::image
