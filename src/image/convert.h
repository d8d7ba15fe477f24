#pragma once
// Converts an image to other components, another type, or reversed rows. u8 and u16 stand for 0..1.

#include <cstdint>

#include "image/image.h"

namespace glibra::image {

/// An RGBA picture whose components are all 0.
Image blankImage(std::uint64_t width, std::uint64_t height, Component type);

/// The same picture with 1 to 4 components: grey is copied to red, green and blue; missing alpha is 1;
/// superfluous components are dropped (the grey of a colour picture is its red).
Image withComponents(const Image& image, int components);

/// The same picture in another type. Integers are limited to 0..1 and rounded, with NaN as 0; 8 bits become
/// 16 exactly.
Image withType(const Image& image, Component type);

/// Calls use(zero) with a 0 of the type of the components: std::uint8_t, std::uint16_t or float.
template <class Use>
auto withZeroOf(Component type, const Use& use) {
    switch (type) {
        case Component::u8:
            return use(std::uint8_t{});
        case Component::u16:
            return use(std::uint16_t{});
        case Component::f32:
            break;
    }
    return use(float{});
}

/// True if the data have the length that width, height, components and type require, and there is at least
/// one pixel.
bool isConsistent(const Image& image);

}  // namespace glibra::image
