#pragma once
// FLIP, the difference that a person sees when two pictures alternate in the same place: Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for Alternating Images",
// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.

#include <vector>

#include "image/image.h"

namespace glibra::image {

struct FlipOptions {
    /// Pixels per degree of the visual field. The paper's default: a screen 3840 pixels and 0.7 m wide, seen
    /// from 0.7 m.
    double pixelsPerDegree = 67.02064327658226;
    int threads = 0;  ///< 0: one per processor core
};

struct FlipResult {
    double mean = 0;     ///< over all pixels, 0 (the same) to 1; the figure that papers report
    double largest = 0;  ///< largest error of a pixel
    int x = 0, y = 0;    ///< place of the first largest error, from the top left
    int width = 0, height = 0;
    std::vector<float> errors;  ///< the error of each pixel, 0..1; rows from top to bottom
};

/// The LDR-FLIP of two pictures. Their values are sRGB as on a screen: limited to 0..1, NaN as 0; but if only
/// one of two values is NaN, the error is 1. The definition has no alpha: pictures that are not opaque are
/// compared over black and over white, and the larger error counts. Grey pictures are RGB with three equal
/// components. The edge pixels continue beyond the picture, as in the authors' implementation. Pictures of
/// different sizes, or without pixels, have mean 1 and no errors.
///
/// Computed in float with separated filters; weights below 1e-8 of the largest are dropped. The number of
/// threads does not change a bit of the result. Mean and pixels are within 1e-4 of an evaluation in double.
FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options = {});

}  // namespace glibra::image
