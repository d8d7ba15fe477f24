#pragma once
// The first directory of a TIFF file (Adobe, "TIFF Revision 6.0", and BigTIFF): its sizes, and what changes
// the picture besides its samples.

#include <glibra/result.h>

#include <cstdint>
#include <span>
#include <vector>

#include "image/limits.h"

namespace glibra::image {

struct TiffHeader {
    std::uint64_t width = 0, height = 0;
    std::uint64_t bits = 1;     ///< per sample
    bool hasBits = false;       ///< the file says how many; otherwise it is 1
    std::uint64_t samples = 1;  ///< per pixel
    std::uint64_t sampleFormat =
        1;                  ///< 1 whole numbers, 2 whole numbers with a sign, 3 floating-point numbers
    bool isUniform = true;  ///< all samples have the same bits and format
    std::uint64_t tileWidth = 0, tileHeight = 0;
    std::uint64_t photometric = 1;  ///< what samples mean: 0 and 1 grey, 2 RGB, 3 a palette, 5 inks, 6 YCbCr
    std::size_t photometricAt = 0;  ///< its lowest byte in the file; 0: it has none
    std::uint64_t compression = 1;
    std::uint64_t predictor = 1;   ///< 2: differences of whole numbers, 3: of floating-point numbers
    std::uint64_t fillOrder = 1;   ///< 2: the first bit of a byte is the lowest one
    unsigned orientation = 1;      ///< 1 to 8, as in TIFF 6.0: 1 is upright
    bool associatedAlpha = false;  ///< colours are multiplied by alpha
};

/// Errors: file-E04 damaged, or a combination for which no test has compared OpenImageIO's pixels with what
/// the file holds; file-E09 exceeds the limits.
Result<TiffHeader> readTiffHeader(std::span<const std::byte> file, const FileLabel& label,
                                  const Limits& limits = {});

/// The same samples with the lowest as black: OpenImageIO inverts samples of some depths only if white is
/// zero. The header must have white as zero.
std::vector<std::byte> withBlackAsZero(std::span<const std::byte> file, const TiffHeader& header);

/// The file with a field for its bits per sample, 1, which it lacks; without it, OpenImageIO takes 8. Empty
/// if that cannot be done.
std::vector<std::byte> withBitsPerSample(std::span<const std::byte> file);

/// The orientation in the first directory, 1 to 8; 1 also if there is none or the bytes are damaged. EXIF
/// data have this form, too.
unsigned tiffOrientation(std::span<const std::byte> bytes);

}  // namespace glibra::image
