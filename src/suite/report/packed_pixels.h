#pragma once
// Pixels and files as texts in a page.

#include <cstddef>
#include <span>
#include <string>

#include "image/image.h"

namespace glibra::suite {

/// A JSON object with width, height, components, type and data of a picture. The data is each row minus the
/// row above it (bytes modulo 256), compressed as zlib, in base64.
std::string packedPixels(const image::Image& picture);

/// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes);

}  // namespace glibra::suite
