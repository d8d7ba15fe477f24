#pragma once

#include "image/image.h"

namespace glibra::bench {

/// The displacement between two pictures in pixels: the smallest radius r, 0 to `most`, such that at least
/// 999 of 1000 pixels of either picture have values that lie, to within 8/255, between the smallest and the
/// largest value of the other within r pixels around the same place. Both are RGB or RGBA bytes of equal
/// size. `most` + 1 if there is no such radius.
int displacement(const image::Image& a, const image::Image& b, int most);

}  // namespace glibra::bench
