#pragma once
// Pictures larger than the driver or its memory allows are drawn in parts, which join without a seam.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"

namespace glibra::render {

/// A rectangle of the picture, in pixels from the picture's lower left corner.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Tiles of one size, and the part of each tile that goes into the picture. A tile is larger than its part by
/// a margin, as far as the picture reaches, because points and lines that begin outside the part may extend
/// into it.
struct TileGrid {
    std::vector<Tile> tiles;
    std::vector<Tile> parts;
};

/// Returns one tile if the picture fits into `largest` (pixels per side) and `mostPixels`, and `wanted` (the
/// side of a part) is 0.
TileGrid tileGrid(int width, int height, int wanted, int largest, std::int64_t mostPixels);

/// Copies the pixels of a part (top row first) to its place in the picture.
void pasteTile(std::span<const std::byte> pixels, const Tile& part, image::Image& picture);

}  // namespace glibra::render
