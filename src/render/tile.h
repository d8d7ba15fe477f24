#pragma once

namespace glibra::render {

/// The part of the picture that the window's target shows, in pixels from the picture's lower left corner.
struct Tile {
    int x = 0, y = 0, width = 0, height = 0;
};

}  // namespace glibra::render
