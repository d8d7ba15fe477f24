#pragma once
// Alpha, which is not associated with the colours of an Image: they are not multiplied by it; and inverted
// colours.

#include "image/image.h"

namespace glibra::image {

/// Divides the colours of an RGBA picture by alpha. Integers are limited to their range and rounded; colours
/// with alpha 0 stay.
void unassociateAlpha(Image& image);

/// Turns red, green and blue of an RGBA picture over: 1 becomes 0.
void invertColors(Image& image);

/// True if the picture has alpha that is not 1 somewhere.
bool isTransparent(const Image& image);

}  // namespace glibra::image
