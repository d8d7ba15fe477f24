#pragma once
// The two pictures of a case, glibra's and the oracle's, and the difference between them.

#include <memory>
#include <string>

#include "case.h"

namespace glibra::oracle {

/// The difference between two pictures of the same size.
struct Difference {
    int largest = 0;   ///< largest difference of any component of any pixel, 0..255
    int pixels = 0;    ///< number of pixels that differ
    int x = 0, y = 0;  ///< a pixel with the largest difference, from the top left
};
Difference difference(const Pixels& a, const Pixels& b);

/// The number of different colours, and of pixels that differ from the background (the top left pixel).
struct Content {
    int colors = 0;
    int pixels = 0;
};
Content contentOf(const Pixels& picture);

/// Draws cases both ways. It makes a temporary folder with the textures pattern.png (2D, 64 x 64), ramp.png
/// (1D, 16) and right.png, left.png, top.png, bottom.png, front.png, back.png (cube, 32 x 32), and removes it
/// at its end.
class BothWays {
  public:
    BothWays();
    BothWays(const BothWays&) = delete;
    BothWays& operator=(const BothWays&) = delete;
    ~BothWays();

    /// glibra's picture, drawn with the shaders translated to core GLSL. Throws std::runtime_error with the
    /// diagnostics if there is no picture.
    Pixels translated(const Case& each);
    /// The oracle's picture, drawn with the shaders as they are written.
    Pixels asWritten(const Case& each);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::oracle
