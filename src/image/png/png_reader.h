#pragma once
// Reads PNG files of every colour type and bit depth, interlaced or not. libspng reads them; the most common
// kind, 8 bits, RGB or RGBA, not interlaced, is unpacked by libdeflate in one piece, three to four times as
// fast.

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/file.h"
#include "image/image.h"

namespace glibra::image {

/// RGBA: u8 for up to 8 bits per component, u16 for 16. Grey is copied to r, g, b. Alpha comes from an alpha
/// channel or a tRNS chunk, otherwise it is 1. Gamma, ICC profiles, significant bits and EXIF are ignored
/// (shownOtherwise() finds files with them). Errors: file-E04 damaged or short; file-E09 exceeds the limits.
Result<Image> decodePng(std::span<const std::byte> file, const FileLabel& label, const Limits& limits = {});

/// The quick way: the picture as RGBA, u8. Empty if the file is of another kind than the most common one or
/// anything in it is wrong; decodePng() then reads it with libspng, which reports the error. Reserves memory
/// for width x height pixels, which the caller has checked.
std::optional<Image> decodeUsualPng(std::span<const std::byte> file);

/// A chunk of another kind than IHDR, IDAT and IEND.
struct PngChunk {
    std::string_view type;  ///< four letters, in the file
    std::span<const std::byte> content;
    bool afterData = false;  ///< it stands after the IDAT chunks
};

/// The facts about a PNG file that are known without decoding its pixels.
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

/// Why a browser or another viewer may show another picture of a PNG file than decodePng() returns: "it is an
/// animation (chunk acTL)", "it has a colour profile (chunk iCCP)", data after its end. Empty if they show
/// the same. Only chunks that are known to change nothing pass: text, dates, square pixels, a palette, one
/// transparent colour, statements that the colours are those of sRGB, and the background of opaque pixels.
std::string shownOtherwise(std::span<const std::byte> file);

}  // namespace glibra::image
