#pragma once
// The headers of a DDS file (Microsoft, "Programming guide for DDS"), checked and converted to one form.

#include <glibra/result.h>

#include <array>
#include <cstdint>
#include <span>

#include "image/limits.h"

namespace glibra::image {

/// DXGI_FORMATs of blocks that the image module reads.
inline constexpr std::uint32_t kDxgiBc1 = 71, kDxgiBc2 = 74, kDxgiBc3 = 77, kDxgiBc6 = 95, kDxgiBc7 = 98;

/// What the bits of a component mean.
enum class DdsNumber {
    fraction,        ///< 0..1
    signedFraction,  ///< -1..1
    whole,           ///< by its value
    signedWhole,
    floating  ///< 16 or 32 bits
};

/// Where a component lies within a pixel, counted from its lowest bit.
struct DdsBits {
    std::uint32_t first = 0, count = 0;  ///< count 0: the pixels do not have the component
};

struct DdsHeader {
    std::uint32_t width = 0, height = 0;
    std::uint64_t rowBytes = 0;    ///< of the pixels, or of a row of blocks of 4 x 4 pixels
    std::uint32_t pixelBits = 0;   ///< 0: blocks of 4 x 4 pixels
    std::uint32_t blockBytes = 0;  ///< of such a block
    std::uint32_t blockParts =
        0;  ///< components that lie in parts of 8 bytes (BC4: 1, BC5: 2); 0: of other kinds
    std::uint32_t blockDxgi = 0;    ///< of other kinds: their DXGI_FORMAT, one for each way to read blocks
    std::array<DdsBits, 4> bits{};  ///< red, green, blue, alpha
    DdsNumber number = DdsNumber::fraction;
    bool isGrey = false;         ///< the first component stands for red, green and blue
    bool premultiplied = false;  ///< colours are multiplied by alpha
    std::size_t dataOffset = 0;
};

/// Reads and checks everything before the pixels. Only the first picture counts: the largest level, the first
/// face of a cube map, the first layer of an array. Errors: file-E04, also for volumes and for kinds of
/// pixels that are not known.
Result<DdsHeader> readDdsHeader(std::span<const std::byte> file, const FileLabel& label);

}  // namespace glibra::image
