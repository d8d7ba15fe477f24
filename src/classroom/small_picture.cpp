#include "classroom/small_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "classroom/effect.h"
#include "image/gif/gif_writer.h"
#include "image/png/png_writer.h"
#include "suite/report/packed_pixels.h"

namespace glibra::classroom {
namespace {

constexpr std::string_view kPng = "data:image/png;base64,", kGif = "data:image/gif;base64,";

}  // namespace

std::string smallPicture(const image::Image& picture) {
    constexpr int kLongest = 256;  // pixels
    constexpr int kSmallest = 12;  // of libdeflate's levels
    constexpr std::size_t kLarge = 24U << 10U;
    const Colors colors = reduced(picture, kLongest);
    image::Image small{colors.width, colors.height, 3, image::Component::u8, {}};
    for (const Color& each : colors.at)
        for (const float one : each) small.data.push_back(static_cast<std::byte>(std::lround(255 * one)));
    const std::vector<std::byte> png =
        image::encodePng(small, {.level = kSmallest, .text = {}, .threads = 1});
    if (png.size() <= kLarge) return std::string(kPng) + suite::base64(png);
    const std::vector<std::byte> gif = image::encodeGif(small);
    return gif.size() < png.size() ? std::string(kGif) + suite::base64(gif)
                                   : std::string(kPng) + suite::base64(png);
}

bool isSmallPicture(std::string_view address) {
    const auto isDigit = [](char each) {
        return (each >= 'a' && each <= 'z') || (each >= 'A' && each <= 'Z') || (each >= '0' && each <= '9') ||
               each == '+' || each == '/' || each == '=';
    };
    return (address.starts_with(kPng) || address.starts_with(kGif)) &&
           std::ranges::all_of(address.substr(kPng.size()), isDigit);
}

}  // namespace glibra::classroom
