#pragma once
// A picture of a difference in characters.

#include <string>
#include <vector>

#include "image/image.h"

namespace glibra::suite {

/// Rows of text without line ends, at most `columns` wide, in the picture's proportions. A cell shows the
/// brightest pixel under it, so that a single pixel is not lost. In colour a character is two cells, one over
/// the other (U+2580, 24-bit escapes), without it one of ten shades of ASCII. Empty if the picture is.
std::vector<std::string> smallHeatMap(const image::Image& difference, int columns, bool color);

}  // namespace glibra::suite
