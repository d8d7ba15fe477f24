#pragma once
// Reads BMP files in every form of language, 8.2: headers of 12, 40, 52, 56, 64, 108 and 124 bytes, 1, 4 and
// 8 bits with palette, 16, 24 and 32 bits, bit fields, RLE4 and RLE8, top-down.

#include <glibra/result.h>

#include <optional>
#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, u8. Alpha is 1, except in 32-bit pixels with an alpha mask. Pixels that run lengths skip have
/// palette entry 0; colours that the palette lacks are black (file-W16). Errors: file-E04 damaged or short;
/// file-E09 exceeds the limits. A BMP file that only wraps a JPEG or PNG is not read here; see
/// embeddedPicture.
Result<Image> decodeBmp(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// The complete JPEG or PNG file that a BMP file wraps (compression 4 and 5); empty if it wraps none.
std::optional<std::span<const std::byte>> embeddedPicture(std::span<const std::byte> file);

}  // namespace glibra::image
