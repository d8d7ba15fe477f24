#pragma once
// Errors in words.

#include <fmt/format.h>

#include <string>

namespace glibra::budget {

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
