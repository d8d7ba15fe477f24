#pragma once
// FLIP, the difference that a person sees when two pictures alternate in the same place:
// Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for
// Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.

#include <vector>

#include "image/image.h"

namespace glibra::image {

struct FlipOptions {
    /// Pixels a degree of the viewer's eye. The paper's default: a screen of 3840 pixels and 0.7 m, seen from
    /// 0.7 m.
    double pixelsPerDegree = 67.02064327658226;
    int threads = 0;  ///< 0: as many as the machine has cores
};

struct FlipResult {
    double mean = 0;     ///< over all pixels, 0 (the same) to 1; the figure that papers give
    double largest = 0;  ///< of one pixel
    int x = 0, y = 0;    ///< of the first largest error, counted from the top left
    int width = 0, height = 0;
    std::vector<float> errors;  ///< a pixel's error, 0..1; rows from top to bottom
};

/// The LDR-FLIP of two pictures. Their values are sRGB as a screen shows them: limited to 0..1, NaN as 0; but
/// where only one of the two is NaN the error is 1. The definition knows no alpha: pictures that are not
/// opaque are seen over black and over white, and the larger error counts. Grey pictures are RGB with three
/// equal components. Beyond the picture its edge pixels go on, as in the authors' implementation. Pictures of
/// different sizes, or without pixels, have mean 1 and no errors.
///
/// Computed in float with separated filters; weights below 1e-8 of the largest are left out. The result is
/// the same bits for any number of threads. Mean and pixels are within 1e-4 of an evaluation in double.
FlipResult flip(const Image& reference, const Image& test, const FlipOptions& options = {});

}  // namespace glibra::image
