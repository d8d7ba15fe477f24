#pragma once
// Pixels in memory. Rows run from top to bottom; the components of a pixel are red, green, blue, alpha (or
// grey, alpha).

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glibra::image {

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

}  // namespace glibra::image
