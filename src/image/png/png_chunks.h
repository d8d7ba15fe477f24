#pragma once
// What a PNG file says about itself, found without decoding its pixels.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace glibra::image {

struct PngChunks {
    std::uint32_t width = 0, height = 0;
    int bitDepth = 0, colorType = 0;
    bool interlaced = false;
    bool transparentColor = false;                 ///< there is a tRNS chunk
    std::vector<std::span<const std::byte>> data;  ///< contents of the IDAT chunks
};

/// Nothing unless the file is whole: signature, header, consecutive data chunks, an end, every checksum
/// right, no critical chunk that the PNG specification does not know, nothing behind the end.
std::optional<PngChunks> pngChunks(std::span<const std::byte> file);

}  // namespace glibra::image
