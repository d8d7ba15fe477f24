#pragma once
// Reads TGA files (Truevision TGA File Format Specification, version 2.0): colour-mapped, true-colour and
// grey, plain and run-length encoded, in all four orientations.

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, u8. The index of a colour-mapped pixel counts from the first entry that the header names. Alpha is
/// that of 32-bit pixels and entries, of 16-bit pixels if the header has attribute bits, and of 16-bit grey;
/// it is 1 if the extension area says that there is none, and colours that it calls premultiplied are divided
/// by it. Errors: file-E04 damaged or short, or an index outside of the colour map; file-E09 exceeds the
/// limits.
Result<Image> decodeTarga(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
