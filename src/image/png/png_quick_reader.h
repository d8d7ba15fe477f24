#pragma once
// Reads the most common kind of PNG file fast: 8 bits, RGB or RGBA, not interlaced, unpacked by libdeflate in
// one piece. Three to four times as fast as libspng on a rendered picture.

#include <optional>
#include <span>

#include "image/image.h"

namespace glibra::image {

/// The picture as RGBA, u8. Empty if the file is of another kind or anything in it is wrong; the general
/// reader then reports the error. Reserves memory for width x height pixels, which the caller has checked.
std::optional<Image> decodeUsualPng(std::span<const std::byte> file);

}  // namespace glibra::image
