#pragma once
// Changes the texels of a texture before they are uploaded.

#include "image/image.h"

namespace glibra::image {

/// Reverses the order of the rows of each slice or face.
void flipRows(TexelBlock& block);

/// Decodes red, green and blue from sRGB (IEC 61966-2-1); the texels become floats. Alpha stays.
void decodeSrgb(TexelBlock& block);

}  // namespace glibra::image
