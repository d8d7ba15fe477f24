#pragma once
// Compares two pictures: how far contours have moved, to parts of a pixel, and how much of the picture has
// changed its colour.

#include <vector>

#include "image/image.h"

namespace glibra::budget {

/// In squares of 16 x 16 pixels the sum of the changes from one picture to the other is divided by the sum of
/// the gradients: where the picture moves by s along its gradient g, values change by s |g|; along a sharp
/// edge that moves by s, the share s of the pixels changes.
class ContourShifts {
  public:
    /// Both pictures have the same size and are RGB or RGBA, bytes or floats. Values are limited to 0..1; NaN
    /// is 0. Shifts are given in units in which a pixel of these pictures has the size `pixel`.
    ContourShifts(const image::Image& from, const image::Image& to, double pixel = 1);
    /// Takes two more pictures of the same scene at another moment: each function gives the larger number.
    void add(const image::Image& from, const image::Image& to);

    /// The shift that 98 of 100 squares do not exceed, among the squares in which some value changes by more
    /// than `change`, 0..1; 0 if there are none.
    [[nodiscard]] double ofChangesAbove(double change) const;

    /// The share of all pixels that change by more than `change`, 0..1, plus the change that a shift by
    /// `shift` would cause there. Only pixels around which both pictures are smooth count: no component
    /// differs by more than 64/255 in the 3 x 3 pixels. So this measures light of another colour, not edges
    /// that have moved.
    [[nodiscard]] double shareOfSmoothChangesAbove(double change, double shift) const;

    /// The constructor's `pixel`.
    [[nodiscard]] double pixel() const { return pixel_; }

  private:
    struct Square {
        double shift = 0, largestChange = 0;
    };
    struct SmoothChange {
        float change = 0, gradient = 0;
    };
    struct Compared {
        std::vector<Square> squares;
        std::vector<SmoothChange> smoothChanges;  ///< only changes above 0
        double pixels = 0;                        ///< number of pixels of the picture
    };
    double pixel_;
    std::vector<Compared> moments_;
};

}  // namespace glibra::budget
