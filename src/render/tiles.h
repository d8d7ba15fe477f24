#pragma once
// Pictures larger than the driver or its memory allows: parts drawn one by one, which join without a seam.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/image.h"
#include "render/tile.h"

namespace glibra::render {

/// Tiles of one size in pixels from the picture's lower left corner, and the parts of them that make up the
/// picture. A tile is larger than its part by a margin inside the picture: points and lines that begin
/// outside the part still reach into it.
struct TileGrid {
    std::vector<Tile> tiles;
    std::vector<Tile> parts;
};

/// One tile if the picture fits `largest` (side in pixels) and `mostPixels`, and `wanted` (side of a part) is
/// 0.
TileGrid tileGrid(int width, int height, int wanted, int largest, std::int64_t mostPixels);

/// Copies a part's pixels (top row first) to its place in the picture.
void pasteTile(std::span<const std::byte> pixels, const Tile& part, image::Image& picture);

}  // namespace glibra::render
