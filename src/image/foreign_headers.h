#pragma once
// The headers of files that libraries decode, as far as they are to be judged before a library sees the file:
// JPEG (ISO/IEC 10918-1, annex B), TIFF (Adobe, "TIFF Revision 6.0", and BigTIFF) and OpenEXR ("OpenEXR File
// Layout").

#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/file.h"

namespace glibra::image {

/// The same picture without EXIF, XMP, ICC profiles, thumbnails and comments, which do not change pixels here
/// (language, 8.2): only APP0 (JFIF) and APP14 (Adobe's colour transform) remain. So no decoder rotates the
/// picture or converts its colours, and no parser sees damaged metadata. From the first invalid segment,
/// everything is kept.
std::vector<std::byte> withoutMetadata(std::span<const std::byte> jpeg);

/// What the header of a JPEG file says.
struct JpegFacts {
    std::uint32_t width = 0, height = 0, components = 0;  ///< 0 if the file has no frame
    std::uint32_t frame =
        0;  ///< the marker's second byte: c0 and c1 sequential, c2 progressive, others are rare
    std::uint32_t bits = 0;    ///< per component
    unsigned orientation = 1;  ///< of the EXIF data, 1 to 8; 1: upright
};
JpegFacts jpegFacts(std::span<const std::byte> jpeg);

/// True if the file has its end-of-image marker. Decoders fill a truncated file with grey and report nothing.
bool hasEndOfImage(std::span<const std::byte> jpeg);

/// The first directory of a TIFF file: its sizes, and what changes the picture besides its samples.
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

/// A window of an OpenEXR file. Both corners belong to it.
struct ExrWindow {
    std::int32_t left = 0, top = 0, right = -1, bottom = -1;

    [[nodiscard]] std::uint64_t width() const;   ///< 0 if the corners are in the wrong order
    [[nodiscard]] std::uint64_t height() const;  ///< likewise
    bool operator==(const ExrWindow&) const = default;
};

enum class ExrNumber : std::uint32_t { whole = 0, half = 1, floating = 2 };

struct ExrChannel {
    std::string name;
    ExrNumber number = ExrNumber::half;
};

/// The header of one part.
struct ExrPart {
    ExrWindow data, display;
    std::vector<ExrChannel> channels;
    std::uint32_t tileWidth = 0, tileHeight = 0;  ///< 0: it has lines
    bool isDeep = false;
};

/// The first part of a file that is not deep, or the first part. Errors: file-E04 damaged; file-E09 a window
/// or a tile exceeds the limits.
Result<ExrPart> readExrHeader(std::span<const std::byte> file, const FileLabel& label,
                              const Limits& limits = {});

/// What two files may have different although the pictures that they show are equal: the places of the
/// windows, and the channels with their types, in words.
std::string describeExr(const ExrPart& part);

}  // namespace glibra::image
