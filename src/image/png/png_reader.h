#pragma once
// PNG: every colour type and bit depth, interlaced or not. By libspng, the usual kind by our own faster way.

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, u8 for up to 8 bits a component and u16 for 16. Grey is copied to r, g, b; alpha comes from an alpha
/// channel or a tRNS chunk, else it is 1. Gamma, ICC profiles, significant bits and EXIF are ignored. Errors:
/// file-E04 damaged or short; file-E09 beyond the limits.
Result<Image> decodePng(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
