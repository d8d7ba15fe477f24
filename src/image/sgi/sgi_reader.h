#pragma once
// Reads SGI pictures (P. Haeberli, "The SGI Image File Format", version 1.00): plain and run-length encoded,
// 8 and 16 bits per component.

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, u8 or u16. One channel is grey, two are grey and alpha, further ones than four are dropped. Errors:
/// file-E04 damaged or short, or a colour map; file-E09 exceeds the limits.
Result<Image> decodeSgi(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
