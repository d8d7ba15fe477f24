#pragma once
// Up to 256 colours for a picture, and the picture with these.

#include <array>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace glibra::image {

struct Indexed {
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< 1 to 256 colours
    std::vector<std::uint8_t> pixels;                  ///< indices into it, top row first
};

/// A picture (RGB, u8, not empty) with a palette: exact if it has 256 colours at most, otherwise with the
/// colours of median cut, and the error of each pixel given to its neighbours.
Indexed indexed(const Image& rgb);

}  // namespace glibra::image
