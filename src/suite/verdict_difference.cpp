#include "suite/verdict_difference.h"

#include <algorithm>
#include <cstdlib>

#include "image/convert.h"

namespace glibra::suite {

std::optional<image::Image> differencePicture(const image::Image& expected, const image::Image& got) {
    if (expected.width != got.width || expected.height != got.height) return std::nullopt;
    const image::Image a = image::withType(expected, image::Component::u8);
    const image::Image b = image::withType(got, image::Component::u8);
    image::Image difference{a.width, a.height, 3, image::Component::u8, {}};
    const auto pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    difference.data.resize(pixels * 3);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto at = [&](const image::Image& image) {
                const auto n = static_cast<std::size_t>(image.components);
                return static_cast<int>(image.data[i * n + std::min(c, n < 3 ? 0 : c)]);
            };
            difference.data[i * 3 + c] = static_cast<std::byte>(std::abs(at(a) - at(b)));
        }
    return difference;
}

}  // namespace glibra::suite
