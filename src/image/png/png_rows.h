#pragma once
// The rows of a picture as PNG packs them: in its byte order, filtered, each with its filter's number in
// front.

#include <cstddef>
#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// One filter for all rows, or for each the one that writeBest chooses.
enum class PngFiltering : std::uint8_t { none, sub, up, bestOfEachRow };

/// `rows` rows from `firstRow` on, of u8 or u16 components, to `to`: rows * (1 + image.rowBytes()) bytes.
void filterRows(const Image& image, int firstRow, int rows, PngFiltering filtering, std::uint8_t* to);

/// What packs these rows best, judged by a seventh of them. Small differences say little about repetitions:
/// where a picture has the same colours again and again, rows that are not filtered can be half as long.
PngFiltering chooseFiltering(const Image& image, int firstRow, int rows);

}  // namespace glibra::image
