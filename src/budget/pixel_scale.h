#pragma once
// How long a small step in model space can become on a picture.

#include <fmt/format.h>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>

#include "geometry/shapes/primitive.h"

namespace glibra::budget {

/// How far outside the picture a place may lie and still count: a mesh reaches further in than its surface.
inline constexpr double kPictureMargin = 1.05;

/// The largest factor, in pixels per model unit, by which a step between two points of the extent is
/// lengthened on the picture, over all directions and all places that can be seen; 0 if no place can be seen.
/// `clipFromModel` is Projection * ModelView; width and height are those of the picture in pixels. Nothing if
/// there is no bound: the matrix is not finite, or a place that can be seen is at w <= 0.
///
/// At window coordinates (x, y) = (width X/w, height Y/w)/2 the Jacobian's rows are
/// width/2 (a_X - X/w a_w) / w and height/2 (a_Y - Y/w a_w) / w, a the rows of the matrix without their last
/// column. Its norm is convex in X/w and Y/w, so it is largest at a corner of the rectangle that the extent
/// and the view share, at the smallest w.
std::optional<double> pixelsPerUnit(const glm::dmat4& clipFromModel, const geometry::Extent& extent,
                                    double width, double height);

// Errors in words.

/// Returns "0.249 px", with enough digits to distinguish it from a bound.
inline std::string pixelText(double pixels) {
    return fmt::format("{:.3g} px", pixels);
}

/// The share of the pixels of a picture, 0..1, that may have another colour for another reason than contours
/// that are off.
inline constexpr double kMostColored = .001;

/// "about 0.2 px off, and 3 of 1000 pixels have another colour"
inline std::string changeText(double pixels, double colored) {
    std::string text = fmt::format("about {} off", pixelText(pixels));
    if (colored <= kMostColored) return text;
    return text + fmt::format(", and {:.2g} of 1000 pixels have another colour", 1000 * colored);
}

}  // namespace glibra::budget
