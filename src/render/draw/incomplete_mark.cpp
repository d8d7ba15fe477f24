#include "render/draw/incomplete_mark.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace glibra::render {
namespace {

constexpr std::array<float, 4> kYellow{1.F, 0.8F, 0.F, 1.F};
constexpr std::array<float, 4> kBlack{0.F, 0.F, 0.F, 1.F};

void setPixel(image::Image& picture, int x, int y, const std::array<float, 4>& color) {
    const bool isFloat = picture.type == image::Component::f32;
    const std::size_t size = isFloat ? sizeof(float) : 1;
    const auto components = static_cast<std::size_t>(picture.components);
    std::byte* pixel = picture.data.data() + static_cast<std::size_t>(y) * picture.rowBytes() +
                       static_cast<std::size_t>(x) * components * size;
    for (std::size_t i = 0; i < components; ++i)
        if (isFloat)
            std::memcpy(pixel + i * size, &color.at(i), size);
        else
            pixel[i] = static_cast<std::byte>(color.at(i) * 255.F);
}

}  // namespace

void markIncomplete(image::Image& picture) {
    if (picture.type == image::Component::u16 || picture.components > 4) return;
    const int width = std::max(4, std::min(picture.width, picture.height) / 40);
    for (int y = 0; y < picture.height; ++y) {
        const bool isEdgeRow = y < width || y >= picture.height - width;
        for (int x = 0; x < picture.width; ++x) {
            if (!isEdgeRow && x == width && picture.width > 2 * width) x = picture.width - width;
            setPixel(picture, x, y, (x + y) / (2 * width) % 2 == 0 ? kYellow : kBlack);
        }
    }
}

}  // namespace glibra::render
