#pragma once
// Compares the structure of two pictures: edges may move by one pixel, as between the rasterisers of
// different drivers, but shapes that are missing, added or changed count. FLIP reports both.

#include "image/image.h"

namespace glibra::image {

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

}  // namespace glibra::image
