#pragma once
// What a report shows between two pictures.

#include <optional>

#include "image/image.h"

namespace glibra::suite {

/// Where and how much two pictures differ; nothing if they have different sizes.
std::optional<image::Image> differencePicture(const image::Image& expected, const image::Image& got);

}  // namespace glibra::suite
