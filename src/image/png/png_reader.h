#pragma once
// Reads PNG files of every colour type and bit depth, interlaced or not. libspng reads them; png_quick_reader
// reads the most common kind.

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA: u8 for up to 8 bits per component, u16 for 16. Grey is copied to r, g, b. Alpha comes from an alpha
/// channel or a tRNS chunk, otherwise it is 1. Gamma, ICC profiles, significant bits and EXIF are ignored
/// (png_appearance.h finds files with them). Errors: file-E04 damaged or short; file-E09 exceeds the limits.
Result<Image> decodePng(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
