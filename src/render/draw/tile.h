#pragma once

namespace glibra::render {

/// A rectangle of the picture, in pixels from the picture's lower left corner.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

}  // namespace glibra::render
