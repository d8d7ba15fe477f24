#pragma once
// Whether a student has handed in something else since points were typed.

#include <glibra/render.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "image/image.h"

namespace glibra::classroom {

/// A digest of what was handed in, by names and contents; of files beyond a limit by their sizes alone. Of a
/// folder these are all its files; of a scene that lies alone among the submissions it is the scene and all
/// that the pictures read of that folder, but not what was given to all (`shaders` and `textures`).
std::string digestOfHandIn(const std::filesystem::path& handedIn, std::span<const RenderOptions> pictures);

// Pictures for pages that are sent: small ones.

/// A picture as the address of an <img>, which has its content: with at most 256 pixels on the longer side,
/// and 256 colours if it would be more than 24 KiB otherwise.
std::string smallPicture(const image::Image& picture);

/// True for what smallPicture() returns: nothing but a picture, whoever sent it.
bool isSmallPicture(std::string_view address);

}  // namespace glibra::classroom
