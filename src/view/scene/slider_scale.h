#pragma once
// Numbers as a user sets them: where a slider's thumb stands for a value, which value a place of the thumb
// means, and what is typed into a field.

#include <optional>
#include <string_view>

#include "render/live/knobs.h"

namespace glibra::view {

struct SliderScale {
    double minimum = 0, maximum = 1;  ///< minimum < maximum
    bool isInteger = false;
    bool isLogarithmic = false;  ///< only with a positive minimum

    /// 0 at the minimum, 1 at the maximum; values beyond the ends get 0 or 1.
    [[nodiscard]] double positionOf(double value) const;
    /// The value at that position, which is clamped to 0..1. The value is rounded to a thousandth of the
    /// power of ten below the range, on a logarithmic scale of the value; `isFine` gives two digits more.
    /// Positions 0 and 1 are exactly the ends, and nothing but 0 rounds to a number near 0.
    [[nodiscard]] double valueAt(double position, bool isFine = false) const;
    /// The value after a move by that part of the scale; integers move by at least 1.
    [[nodiscard]] double moved(double value, double positions, bool isFine = false) const;
};

/// The scale of a knob with a range. It is logarithmic if the range is positive and spans three decades or
/// more.
SliderScale scaleOf(const render::Knob& knob);

/// 0 for what dragging by steps of that size leaves of 0 (-1.767e-15); other values stay.
double withoutLeftover(double value, double step);

/// "0.5", "0,5", "1/3", "2*sqrt(3)": an expression of the scene language without names of a scene (language,
/// 1.8), with a point or a comma before the fraction. Nothing if the text is no number that a float has.
std::optional<double> typedNumber(std::string_view text);

}  // namespace glibra::view
