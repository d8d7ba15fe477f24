#include "image/alpha.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

template <class Value>
constexpr Value kOpaque = std::is_integral_v<Value> ? std::numeric_limits<Value>::max() : Value{1};

template <class Value>
void divideColors(Image& image) {
    for (std::size_t at = 0; at + 4 * sizeof(Value) <= image.data.size(); at += 4 * sizeof(Value)) {
        std::byte* const pixel = image.data.data() + at;
        const auto alpha = valueAt<Value>(pixel, 3);
        if (alpha == 0 || alpha == kOpaque<Value>) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            auto color = valueAt<Value>(pixel, c);
            if constexpr (std::is_integral_v<Value>)
                color = static_cast<Value>(std::min<std::uint64_t>(
                    (std::uint64_t{color} * kOpaque<Value> + alpha / 2U) / alpha, kOpaque<Value>));
            else
                color /= alpha;
            std::memcpy(pixel + c * sizeof(Value), &color, sizeof color);
        }
    }
}

template <class Value>
void turnColorsOver(Image& image) {
    for (std::size_t at = 0; at + 4 * sizeof(Value) <= image.data.size(); at += 4 * sizeof(Value))
        for (std::size_t c = 0; c < 3; ++c) {
            std::byte* const component = image.data.data() + at + c * sizeof(Value);
            const auto turned = static_cast<Value>(kOpaque<Value> - valueAt<Value>(component, 0));
            std::memcpy(component, &turned, sizeof turned);
        }
}

template <class Value>
bool hasOtherThanOpaque(const Image& image) {
    const auto components = static_cast<std::size_t>(image.components);
    const std::size_t count = image.data.size() / sizeof(Value);
    for (std::size_t i = components - 1; i < count; i += components)
        if (valueAt<Value>(image.data.data(), i) != kOpaque<Value>) return true;
    return false;
}

}  // namespace

void unassociateAlpha(Image& image) {
    if (image.components != 4) return;
    withZeroOf(image.type, [&](auto zero) { divideColors<decltype(zero)>(image); });
}

void invertColors(Image& image) {
    if (image.components != 4) return;
    withZeroOf(image.type, [&](auto zero) { turnColorsOver<decltype(zero)>(image); });
}

bool isTransparent(const Image& image) {
    if (image.components % 2 != 0) return false;
    return withZeroOf(image.type, [&](auto zero) { return hasOtherThanOpaque<decltype(zero)>(image); });
}

}  // namespace glibra::image
