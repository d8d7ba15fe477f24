#pragma once
// Reads the first picture of a GIF file (CompuServe, "Graphics Interchange Format", versions 87a and 89a).

#include <glibra/result.h>

#include <span>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// RGBA, u8, of the size of the logical screen, which grows if the picture reaches beyond it. What the
/// picture does not cover and what has the transparent colour is black with alpha 0. Errors: file-E04 damaged
/// or short, or an index outside of the colour table; file-E09 exceeds the limits.
Result<Image> decodeGif(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

}  // namespace glibra::image
