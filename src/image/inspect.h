#pragma once
// Checks of rendered pictures.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// True if all pixels have the same bits (also for a picture of one pixel or none).
bool isOneColor(const Image& image);

/// The number of components that are NaN or infinite; always 0 for u8 and u16.
struct NonFinite {
    std::uint64_t nan = 0;
    std::uint64_t infinite = 0;
    int x = 0, y = 0;  ///< of the first one, counted from the top left
};
NonFinite countNonFinite(const Image& image);

}  // namespace glibra::image
