#pragma once
// Whether other programs show the picture that decodePng() returns.

#include <cstddef>
#include <span>
#include <string>

namespace glibra::image {

/// Why a browser or another viewer may show another picture of a PNG file than decodePng() returns: "it is an
/// animation (chunk acTL)", "it has a colour profile (chunk iCCP)", data after its end. Empty if they show
/// the same. Only chunks that are known to change nothing pass: text, dates, square pixels, a palette, one
/// transparent colour, and statements that the colours are those of sRGB.
std::string shownOtherwise(std::span<const std::byte> file);

}  // namespace glibra::image
