#pragma once
// Compares what two pictures show when colours, model and camera are free: whether the pattern on the objects
// is the same, wherever they stand. FLIP and structure compare the pixels of one place.

#include "image/image.h"

namespace glibra::classroom {

/// True if all pixels of a picture have one colour, up to 2 of 255 steps, except for one pixel in 5,000: the
/// scene has drawn nothing that is seen.
bool showsNothing(const image::Image& picture);

/// From 0, nothing in common, to 1. Both pictures are cut to what differs from their background and scaled to
/// one size, with the detail of the smaller one. Then two figures are computed, and the larger counts:
///   aligned   the correlation of the edges inside of the objects in two scales, shifted to where it is
///             largest, times the overlap of the shapes: 1 for the same scene in other colours
///   pattern   0.95 times a product: how well the parts of each pattern are found in the other one, at any
///             place, angle and size, and how much they repeat (pattern_points.h); how alike their statistics
///             are, the angles between edges that are near to each other, and the shares of
///             the two main tones; and, where the outlines are the same, their sizes. It is high for the same
///             pattern on another model or from elsewhere. A pattern that is finer than the other one is also
///             looked at in half of the picture.
/// A picture that shows nothing has 0, unless both do. A pattern that is finer than about 3 pixels, of 128 on
/// the longer side of the objects, is not recognised.
double likeness(const image::Image& expected, const image::Image& got);

/// How much two pictures of one scene differ, 0 to 1.
struct Reaction {
    /// The mean FLIP of the pixels that show objects in either of them, so that it is the same from near and
    /// from far; of all pixels if the backgrounds differ.
    double mean = 0;
    /// The mean FLIP of those of these pixels that change: the same for a small and a large part of a
    /// picture. A change of less than 0.2 % of the pixels counts as one of so many.
    double strength = 0;
};
Reaction reaction(const image::Image& one, const image::Image& other);

}  // namespace glibra::classroom
