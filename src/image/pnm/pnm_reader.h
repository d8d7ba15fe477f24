#pragma once
// Reads the pictures of Netpbm (pbm(5), pgm(5), ppm(5)) and their floats, PFM (P. Debevec, "PFM Portable
// FloatMap Image Format").

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// P1 to P6 as RGBA: u8 for a maximum up to 255, u16 for more. Grey is copied to r, g, b; alpha is 1. Of
/// several pictures the first is read. Errors: file-E04 damaged or short; file-E09 exceeds the limits.
Result<Image> decodePnm(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// PF and Pf as RGBA, f32, multiplied by the scale of the header. Errors as above.
Result<Image> decodePfm(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
