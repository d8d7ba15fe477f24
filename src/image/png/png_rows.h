#pragma once
// The rows of a picture as PNG packs them: in its byte order and filtered, each after the number of its
// filter.

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// One filter for all rows, or for each row the one that writeBest chooses.
enum class PngFiltering : std::uint8_t { none, sub, up, bestOfEachRow };

/// Writes `rows` rows from `firstRow`, of u8 or u16 components, to `to`: rows * (1 + image.rowBytes()) bytes.
void filterRows(const Image& image, int firstRow, int rows, PngFiltering filtering, std::uint8_t* to);

/// The way to filter that packs these rows best, judged by a seventh of them. Small differences do not
/// predict repetitions: if a picture repeats the same colours, unfiltered rows can be packed to half the
/// size.
PngFiltering chooseFiltering(const Image& image, int firstRow, int rows);

}  // namespace glibra::image
