#pragma once
// How many pixels a small step in model space can become on a picture.

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

namespace glibra::budget {

/// Where an object lies, model space: in the box, and no further from the box's centre than `radius`.
struct Bounds {
    glm::dvec3 low{0.0}, high{0.0};
    double radius = std::numeric_limits<double>::infinity();
};

/// The largest factor, in pixels a model unit, by which the picture of a step between two points of the
/// bounds can be longer than the step, over all directions and all places that can be seen; 0 if none can.
/// `clipFromModel` is Projection * ModelView, width and height are those of the picture in pixels. Nothing
/// where there is no bound: the matrix is not finite, or a place that can be seen is at w <= 0.
///
/// At window coordinates (x, y) = (width X/w, height Y/w)/2 the Jacobian's rows are
/// width/2 (a_X - X/w a_w) / w and height/2 (a_Y - Y/w a_w) / w, a the rows of the matrix without their last
/// column. Its norm is convex in X/w and Y/w, so the largest is at a corner of the rectangle that the bounds
/// and the view share, at the smallest w.
std::optional<double> pixelsPerUnit(const glm::dmat4& clipFromModel, const Bounds& bounds, double width,
                                    double height);

}  // namespace glibra::budget
