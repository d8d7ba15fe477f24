#pragma once
// Reads DDS files whose pixels are not compressed, or compressed as BC4 and BC5, and prepares the others for
// the image module.

#include <glibra/result.h>

#include <optional>
#include <span>
#include <vector>

#include "image/image.h"
#include "image/limits.h"

namespace glibra::image {

/// A DDS file that has the first picture of another one alone, so that the module finds no further levels,
/// faces, layers or lengths.
struct DdsBlocks {
    std::vector<std::byte> file;
    bool premultiplied = false;  ///< its colours are multiplied by alpha
};

/// What a DDS file holds: pixels, or blocks for the module.
struct DdsContent {
    std::optional<Image> image;
    DdsBlocks blocks;
};

/// RGBA: u8 for up to 8 bits per component, u16 for up to 16, f32 for more, for floats, for fractions with a
/// sign and for whole numbers, which stay what they are; u8 for BC4 and BC5 without a sign. A single
/// component is grey; others that are missing are 0, alpha 1. Errors: file-E04 damaged, short or of an
/// unknown kind; file-E09 exceeds the limits.
Result<DdsContent> decodeDds(std::span<const std::byte> file, const FileLabel& label,
                             const Limits& limits = {});

}  // namespace glibra::image
