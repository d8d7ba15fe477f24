#pragma once
// RLE4 and RLE8 of BMP files (Microsoft, "Bitmap Compression").

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace glibra::image {

/// Red, green, blue, alpha.
using BmpPixel = std::array<std::uint8_t, 4>;

struct RunLengthLayout {
    std::uint32_t width, height;
    bool topDown;
    std::uint32_t bits;  ///< 4 or 8
};

/// Fills `pixels` (top row first) by the commands in `data`; pixels that no command sets are colors[0].
/// `colors` has 2^bits entries. Pixels beyond the end of a row are dropped. Returns the number of complete
/// rows: layout.height if the picture is complete (all rows reached, or an end-of-picture command), fewer if
/// the data end early.
std::uint64_t decodeRunLengths(std::span<const std::byte> data, const RunLengthLayout& layout,
                               std::span<const BmpPixel> colors, std::span<BmpPixel> pixels);

}  // namespace glibra::image
