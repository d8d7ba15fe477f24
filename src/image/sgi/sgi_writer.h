#pragma once
// Writes SGI pictures (P. Haeberli, "The SGI Image File Format", version 1.00).

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace glibra::image {

inline constexpr int kLargestSgiSide = 65'535;  ///< pixels

/// An SGI file without run lengths: RGB, or RGBA if the picture has alpha; 8 bits per component, 16 for u16
/// and f32, whose components are limited to 0..1. The sides of the picture are at most kLargestSgiSide.
std::vector<std::byte> encodeSgi(const Image& image);

}  // namespace glibra::image
