#pragma once
// Pictures for pages that are sent: small ones.

#include <string>
#include <string_view>

#include "image/image.h"

namespace glibra::classroom {

/// A picture as the address of an <img>, which has its content: with at most 256 pixels on the longer side,
/// and 256 colours if it would be more than 24 KiB otherwise.
std::string smallPicture(const image::Image& picture);

/// True for what smallPicture() returns: nothing but a picture, whoever sent it.
bool isSmallPicture(std::string_view address);

}  // namespace glibra::classroom
