#pragma once
// The facts about a PNG file that are known without decoding its pixels.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace glibra::image {

/// A chunk of another kind than IHDR, IDAT and IEND.
struct PngChunk {
    std::string_view type;  ///< four letters, in the file
    std::span<const std::byte> content;
    bool afterData = false;  ///< it stands after the IDAT chunks
};

struct PngChunks {
    std::uint32_t width = 0, height = 0;
    int bitDepth = 0, colorType = 0;
    bool interlaced = false;
    bool transparentColor = false;                 ///< there is a tRNS chunk
    std::vector<std::span<const std::byte>> data;  ///< contents of the IDAT chunks
    std::vector<PngChunk> others;                  ///< in the order of the file
};

/// Empty unless the file is complete: signature, header, consecutive data chunks and an end, every checksum
/// correct, no critical chunk that the PNG specification does not define, and nothing after the end.
std::optional<PngChunks> pngChunks(std::span<const std::byte> file);

}  // namespace glibra::image
