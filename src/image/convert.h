#pragma once
// An image with other components or another type; also rows upside down. u8 and u16 stand for 0..1.

#include "image/image.h"

namespace glibra::image {

/// The same picture with 1 to 4 components: grey is copied to red, green and blue, alpha that is missing is
/// 1, what is too much is left out (grey of a colour picture is its red).
Image withComponents(const Image& image, int components);

/// The same picture in another type. To integers: limited to 0..1 and rounded, NaN as 0; 8 bits become 16
/// exactly.
Image withType(const Image& image, Component type);

/// True if the data are as long as width, height, components and type say, and there is at least one pixel.
bool isConsistent(const Image& image);

}  // namespace glibra::image
