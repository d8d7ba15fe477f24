#pragma once
// The segments of a JPEG file (ISO/IEC 10918-1, annex B).

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace glibra::image
