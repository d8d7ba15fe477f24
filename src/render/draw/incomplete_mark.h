#pragma once
// The mark of a picture that lacks something (RenderOptions::incomplete).

#include "image/image.h"

namespace glibra::render {

/// Draws a border of black and yellow stripes over the edge of the picture: a fortieth of its smaller side
/// wide, at least 4 pixels. A picture of less than 16 pixels a side is covered by it.
void markIncomplete(image::Image& picture);

}  // namespace glibra::render
