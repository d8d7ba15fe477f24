#pragma once
// Pictures as reports show them.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"

namespace glibra::suite {

// Pixels and files as texts in a page.

/// A JSON object with width, height, components, type and data of a picture. The data is each row minus the
/// row above it (bytes modulo 256), compressed as zlib, in base64.
std::string packedPixels(const image::Image& picture);

/// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes);

// A difference picture made of characters.

/// Returns rows of text without line ends, at most `columns` wide, in the proportions of the picture. A cell
/// shows its brightest pixel, so that a single pixel is not lost. In colour a character is two cells, one
/// above the other (U+2580, 24-bit escapes); otherwise it is one of ten shades of ASCII. Empty if the picture
/// is.
std::vector<std::string> smallHeatMap(const image::Image& difference, int columns, bool color);

}  // namespace glibra::suite
