#pragma once
// Pixels in memory, and in other forms.

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace glibra::image {

// Pixels in memory. Rows run from top to bottom; the components of a pixel are red, green, blue, alpha (or
// grey, alpha).

enum class Component { u8, u16, f32 };

constexpr std::size_t bytesOf(Component component) {
    return component == Component::u8 ? 1 : component == Component::u16 ? 2 : 4;
}

/// A picture of width x height pixels with 1 to 4 components per pixel, rows tightly packed, top row first.
/// u8 and u16 stand for 0..1. Values are not converted between colour spaces.
struct Image {
    int width = 0;
    int height = 0;
    int components = 4;
    Component type = Component::u8;
    std::vector<std::byte> data;

    [[nodiscard]] std::size_t rowBytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(components) * bytesOf(type);
    }
    [[nodiscard]] std::span<const std::byte> row(int y) const {
        return std::span(data).subspan(static_cast<std::size_t>(y) * rowBytes(), rowBytes());
    }
};

/// Texels of a texture, ready for upload: s fastest, then t, then p; t = 0 is the bottom row of a picture. A
/// cube map holds its six faces one after the other (+x -x +y -y +z -z), each starting with GL's first row.
struct TexelBlock {
    int dimensions = 2;  ///< 1, 2 or 3; a cube map is 2 with faces = 6
    int faces = 1;
    int width = 1;
    int height = 1;
    int depth = 1;
    int components = 4;
    Component type = Component::u8;
    std::vector<std::byte> data;
};

// The pixels of an image in another form: other components, another type, turned, without alpha; and checks
// of them. u8 and u16 stand for 0..1.

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

/// What stands for 1 in a type of components.
template <class Value>
inline constexpr Value kOne = std::is_integral_v<Value> ? std::numeric_limits<Value>::max() : Value{1};

/// The curve of sRGB (IEC 61966-2-1): the linear value of an encoded one, and its inverse.
template <std::floating_point Number>
Number linearOfSrgb(Number encoded) {
    return encoded <= Number(.04045) ? encoded / Number(12.92)
                                     : std::pow((encoded + Number(.055)) / Number(1.055), Number(2.4));
}
template <std::floating_point Number>
Number srgbOfLinear(Number linear) {
    return linear <= Number(.0031308) ? Number(12.92) * linear
                                      : Number(1.055) * std::pow(linear, 1 / Number(2.4)) - Number(.055);
}

/// True if the data have the length that width, height, components and type require, and there is at least
/// one pixel.
bool isConsistent(const Image& image);

/// Divides the colours of an RGBA picture by alpha, since those of an Image are not multiplied by it.
/// Integers are limited to their range and rounded; colours with alpha 0 stay.
void unassociateAlpha(Image& image);

/// Turns red, green and blue of an RGBA picture over: 1 becomes 0.
void invertColors(Image& image);

/// True if the picture has alpha that is not 1 somewhere.
bool isTransparent(const Image& image);

/// A picture upright whose file says that its first row is not the top one. `orientation` is the number of
/// TIFF 6.0 and EXIF: where the first row and the first column of the file lie. 1: top and left; 2: top,
/// right; 3: bottom, right; 4: bottom, left; 5: left, top; 6: right, top; 7: right, bottom; 8: left, bottom.
Image upright(Image image, unsigned orientation);

/// True if all pixels have the same bits (also for a picture of one pixel or none).
bool isOneColor(const Image& image);

/// The number of components that are NaN or infinite; always 0 for u8 and u16.
struct NonFinite {
    std::uint64_t nan = 0;
    std::uint64_t infinite = 0;
    int x = 0, y = 0;  ///< of the first one, counted from the top left
};
NonFinite countNonFinite(const Image& image);

/// A rectangle of pixels, such as the part of a frame of an animation that is stored; `right` and `bottom`
/// are outside.
struct Bounds {
    int left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool isEmpty() const { return right <= left || bottom <= top; }
};

/// Where two RGB pictures (u8) of one size differ; empty if they are equal.
Bounds differenceOf(const Image& a, const Image& b);

/// That rectangle of an RGB picture (u8).
Image partOf(const Image& image, const Bounds& bounds);

/// Reverses the order of the rows of each slice or face.
void flipRows(TexelBlock& block);

/// Decodes red, green and blue from sRGB (IEC 61966-2-1); the texels become floats. Alpha stays.
void decodeSrgb(TexelBlock& block);

}  // namespace glibra::image
