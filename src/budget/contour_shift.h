#pragma once
// How far what one picture shows lies beside its place in another, to parts of a pixel, and how much of it
// has other colours.

#include <vector>

#include "image/image.h"

namespace glibra::budget {

/// In squares of 16 x 16 pixels the sum of the changes from one picture to the other is divided by the sum of
/// the gradients: what moves along its gradient g by s changes by s |g|, and of the pixels along a sharp edge
/// that moves by s, a share of s changes.
class ContourShifts {
  public:
    /// Both pictures RGB or RGBA bytes or floats of one size; values are limited to 0..1 first, NaN is 0.
    /// Shifts count in units of which a pixel of these pictures has `pixel`.
    ContourShifts(const image::Image& from, const image::Image& to, double pixel = 1);

    /// What 98 of 100 squares stay below, of those in which some value changes by more than `change`, 0..1; 0
    /// if there are none.
    [[nodiscard]] double ofChangesAbove(double change) const;

    /// Share of all pixels that change by more than `change`, 0..1, and what a shift by `shift` would change
    /// there, where both pictures are smooth: in the 3 x 3 pixels around no component differs by more than
    /// 64/255. That is light of another colour, and no edge that has moved.
    [[nodiscard]] double shareOfSmoothChangesAbove(double change, double shift) const;

    /// `pixel` of the constructor.
    [[nodiscard]] double pixel() const { return pixel_; }

  private:
    struct Square {
        double shift = 0, largestChange = 0;
    };
    double pixel_;
    std::vector<Square> squares_;
    struct SmoothChange {
        float change = 0, gradient = 0;
    };
    std::vector<SmoothChange> smoothChanges_;  ///< those above 0
    double pixels_ = 0;                        ///< all
};

}  // namespace glibra::budget
