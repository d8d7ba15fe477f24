#pragma once
// Compares what two pictures show when colours, model and camera are free: whether the pattern on the objects
// is the same, wherever they stand. FLIP and structure compare the pixels of one place.

#include <optional>

#include "image/image.h"

namespace glibra::classroom {

/// True if all pixels of a picture have one colour, up to 2 of 255 steps, except for one pixel in 5,000: the
/// scene has drawn nothing that is seen.
bool showsNothing(const image::Image& picture);

/// From 0, nothing in common, to 1. Both pictures are cut to what differs from their background and scaled to
/// one size; colours are divided by their deviation. Then two figures are computed, and the larger counts:
///   aligned   the correlation of the edges inside of the objects in two scales, shifted to where it is
///             largest, times the overlap of the shapes: 1 for the same scene in other colours
///   pattern   0.9 times how alike the shares of edges are in four scales, weakened by the directions of the
///             edges (up to a rotation) and by the shares of the two main colours: high for the same pattern
///             on another model or from elsewhere
/// A picture that shows nothing has 0, unless both do.
double likeness(const image::Image& expected, const image::Image& got);

}  // namespace glibra::classroom
