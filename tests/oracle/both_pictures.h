#pragma once
// The two pictures of a case, glibra's and the oracle's, and how far they are apart.

#include <memory>
#include <string>

#include "case.h"

namespace glibra::oracle {

/// How two pictures of one size differ.
struct Difference {
    int largest = 0;   ///< of any component of any pixel, 0..255
    int pixels = 0;    ///< that differ at all
    int x = 0, y = 0;  ///< of a pixel with the largest difference, from the top left
};
Difference difference(const Pixels& a, const Pixels& b);

/// Numbers of different colours, and of pixels that are not the background (the top left pixel's colour).
struct Content {
    int colors = 0;
    int pixels = 0;
};
Content contentOf(const Pixels& picture);

/// Draws cases both ways, in a folder of its own that goes with it, with the textures pattern.png (2D, 64 x
/// 64), ramp.png (1D, 16) and right.png, left.png, top.png, bottom.png, front.png, back.png (cube, 32 x 32).
class BothWays {
  public:
    BothWays();
    BothWays(const BothWays&) = delete;
    BothWays& operator=(const BothWays&) = delete;
    ~BothWays();

    /// By glibra: translated to core GLSL. Throws std::runtime_error with the diagnostics if there is no
    /// picture.
    Pixels translated(const Case& each);
    /// By the oracle: as they are written.
    Pixels asWritten(const Case& each);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::oracle
