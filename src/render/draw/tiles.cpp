#include "render/draw/tiles.h"

#include <algorithm>
#include <cstring>

namespace glibra::render {
namespace {

constexpr int kTileMargin = 64;
constexpr int kUsualSide = 4096;

}  // namespace

TileGrid tileGrid(int width, int height, int wanted, int largest, std::int64_t mostPixels) {
    TileGrid grid;
    const bool fits =
        width <= largest && height <= largest && static_cast<std::int64_t>(width) * height <= mostPixels;
    if (fits && (wanted <= 0 || (wanted >= width && wanted >= height))) {
        grid.tiles = grid.parts = {{0, 0, width, height}};
        return grid;
    }
    const int side = std::max(1, std::min(wanted > 0 ? wanted : kUsualSide, largest - 2 * kTileMargin));
    // All tiles have one size, so that one target serves them all. At the borders they are moved inside.
    const int tileWidth = std::min(width, side + 2 * kTileMargin);
    const int tileHeight = std::min(height, side + 2 * kTileMargin);
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            grid.parts.push_back({x, y, std::min(side, width - x), std::min(side, height - y)});
            grid.tiles.push_back({std::clamp(x - kTileMargin, 0, width - tileWidth),
                                  std::clamp(y - kTileMargin, 0, height - tileHeight), tileWidth,
                                  tileHeight});
        }
    }
    return grid;
}

void pasteTile(std::span<const std::byte> pixels, const Tile& part, image::Image& picture) {
    const std::size_t pixelBytes =
        static_cast<std::size_t>(picture.components) * image::bytesOf(picture.type);
    const std::size_t partBytes = static_cast<std::size_t>(part.width) * pixelBytes;
    const int top = picture.height - part.y - part.height;
    for (int row = 0; row < part.height; ++row) {
        const std::size_t to = static_cast<std::size_t>(top + row) * picture.rowBytes() +
                               static_cast<std::size_t>(part.x) * pixelBytes;
        std::memcpy(picture.data.data() + to, pixels.data() + static_cast<std::size_t>(row) * partBytes,
                    partBytes);
    }
}

}  // namespace glibra::render
