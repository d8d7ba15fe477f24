#pragma once
// Reads Radiance pictures (G. Ward, "Real Pixels", Graphics Gems II; Radiance, "Picture file format"): plain
// pixels and both kinds of run lengths, in all eight orientations of the resolution line.

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, f32, upright as the resolution line says; alpha is 1. Lines of the header that do not change the
/// pixels (EXPOSURE and others) are ignored. Errors: file-E04 damaged, short, or with colours other than RGB
/// (XYZE); file-E09 exceeds the limits.
Result<Image> decodeHdr(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
