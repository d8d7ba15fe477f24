#pragma once
// The segments of a JPEG file (ISO/IEC 10918-1, annex B).

#include <cstddef>
#include <span>
#include <vector>

namespace glibra::image {

/// The same picture without EXIF, XMP, ICC profiles, thumbnails and comments, which change no pixel here
/// (8.2): only APP0 (JFIF) and APP14 (Adobe's colour transform) stay. So no decoder can turn the picture or
/// convert its colours, and hostile metadata meet no parser. From the first segment that makes no sense, all
/// is kept as it is.
std::vector<std::byte> withoutMetadata(std::span<const std::byte> jpeg);

/// True if the file goes on to its end-of-image marker. Decoders fill a file that was cut off with grey and
/// say nothing.
bool hasEndOfImage(std::span<const std::byte> jpeg);

}  // namespace glibra::image
