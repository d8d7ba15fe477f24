#pragma once

#include <fmt/format.h>

#include <string>

namespace glibra::budget {

/// Returns "0.249 px", with enough digits to distinguish it from a bound.
inline std::string pixelText(double pixels) {
    return fmt::format("{:.3g} px", pixels);
}

}  // namespace glibra::budget
