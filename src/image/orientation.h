#pragma once
// Turns pictures whose file says that its first row is not the top one.

#include "image/image.h"

namespace glibra::image {

/// The picture upright. `orientation` is the number of TIFF 6.0 and EXIF: where the first row and the first
/// column of the file lie. 1: top and left; 2: top, right; 3: bottom, right; 4: bottom, left; 5: left, top;
/// 6: right, top; 7: right, bottom; 8: left, bottom.
Image upright(Image image, unsigned orientation);

}  // namespace glibra::image
