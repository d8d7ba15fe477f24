#pragma once
// Where two pictures of an animation differ: of each frame only that rectangle is stored.

#include "image/image.h"

namespace glibra::image {

/// A rectangle of pixels; `right` and `bottom` are outside.
struct Bounds {
    int left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool isEmpty() const { return right <= left || bottom <= top; }
};

/// Where two RGB pictures (u8) of one size differ; empty if they are equal.
Bounds differenceOf(const Image& a, const Image& b);

/// That rectangle of an RGB picture (u8).
Image partOf(const Image& image, const Bounds& bounds);

}  // namespace glibra::image
