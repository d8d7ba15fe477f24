#pragma once
// A difference picture made of characters.

#include <string>
#include <vector>

#include "image/image.h"

namespace glibra::suite {

/// Returns rows of text without line ends, at most `columns` wide, in the proportions of the picture. A cell
/// shows its brightest pixel, so that a single pixel is not lost. In colour a character is two cells, one
/// above the other (U+2580, 24-bit escapes); otherwise it is one of ten shades of ASCII. Empty if the picture
/// is.
std::vector<std::string> smallHeatMap(const image::Image& difference, int columns, bool color);

}  // namespace glibra::suite
