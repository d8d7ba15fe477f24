#pragma once
// Text in pictures, in a font of fixed width: the same pixels on every machine.

#include <string_view>

#include "image/image.h"

namespace glibra::image {

/// The size of a character's cell in pixels, at scale 1.
inline constexpr int kCharacterWidth = 8, kLineHeight = 16;

/// Draws a line of text, white with a black outline, so that it can be read on any picture. `left` and `top`
/// are the corner of the first cell in pixels; the outline of the first letter may begin a pixel (times
/// `scale`) further left. Each pixel of the font becomes scale x scale pixels. What lies outside of the
/// picture is cut off. Characters beyond ASCII become '?'.
void drawText(Image& picture, int left, int top, std::string_view text, int scale);

}  // namespace glibra::image
