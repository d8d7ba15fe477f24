#pragma once
// How far what one picture shows lies beside its place in another, to parts of a pixel.

#include <vector>

#include "image/image.h"

namespace glibra::budget {

/// In squares of 16 x 16 pixels the sum of the changes from one picture to the other is divided by the sum of
/// the gradients: what moves along its gradient g by s changes by s |g|, and of the pixels along a sharp edge
/// that moves by s, a share of s changes.
class ContourShifts {
  public:
    /// Both pictures RGB or RGBA floats of one size; values are limited to 0..1 first, NaN is 0. Shifts count
    /// in units of which a pixel of these pictures has `pixel`.
    ContourShifts(const image::Image& from, const image::Image& to, double pixel = 1);

    /// What 98 of 100 squares stay below, of those in which some value changes by more than `change`, 0..1; 0
    /// if there are none.
    [[nodiscard]] double ofChangesAbove(double change) const;

  private:
    struct Square {
        double shift = 0, largestChange = 0;
    };
    std::vector<Square> squares_;
};

}  // namespace glibra::budget
