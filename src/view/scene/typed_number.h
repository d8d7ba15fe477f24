#pragma once
// Numbers that a user types into a field.

#include <optional>
#include <string_view>

namespace glibra::view {

/// "0.5", "0,5", "1/3", "2*sqrt(3)": an expression of the scene language without names of a scene (language,
/// 1.8), with a point or a comma before the fraction. Nothing if the text is no number that a float has.
std::optional<double> typedNumber(std::string_view text);

}  // namespace glibra::view
