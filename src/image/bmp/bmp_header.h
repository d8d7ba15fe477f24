#pragma once
// The headers of a BMP file, checked and converted to one form. Layouts: Microsoft's BITMAPFILEHEADER,
// BITMAPCOREHEADER, BITMAPINFOHEADER, BITMAPV4HEADER and BITMAPV5HEADER, IBM's 64-byte OS/2 2.x header.

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "image/limits.h"

namespace glibra::image {

enum class BmpCompression : std::uint32_t {
    none = 0,
    rle8 = 1,
    rle4 = 2,
    bitFields = 3,
    jpeg = 4,
    png = 5,
    alphaBitFields = 6
};

struct BmpHeader {
    std::uint32_t width = 0, height = 0;
    bool topDown = false;
    std::uint32_t bits = 0;  ///< bits per pixel: 1, 4, 8, 16, 24, 32 (0 for a wrapped JPEG or PNG)
    BmpCompression compression = BmpCompression::none;
    std::array<std::uint32_t, 4> masks{};              ///< red, green, blue, alpha of 16- and 32-bit pixels
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< red, green, blue
    std::size_t dataOffset = 0;                        ///< within the file
};

/// Reads and checks everything before the pixels. Errors: file-E04.
Result<BmpHeader> readBmpHeader(std::span<const std::byte> file, const FileLabel& label);

}  // namespace glibra::image
