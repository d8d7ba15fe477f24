#pragma once
// The pixels of a PNG file: filtered and packed rows.

#include <cstddef>
#include <vector>

#include "image/image.h"

namespace glibra::image {

/// The zlib stream for the IDAT chunks, of u8 or u16 components. The rows are divided into stripes by their
/// number of bytes alone, packed by up to `threads` threads (0: one per processor) and joined, so the number
/// of threads does not change the bytes. `level` is PngOptions::level. Empty if there is not enough memory.
std::vector<std::byte> packPngData(const Image& image, int level, unsigned threads);

}  // namespace glibra::image
