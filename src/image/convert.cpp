#include "image/convert.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "image/bytes.h"

namespace glibra::image {
namespace {

template <class Value>
constexpr Value one() {
    if constexpr (std::is_integral_v<Value>)
        return std::numeric_limits<Value>::max();
    else
        return 1;
}

template <class Value>
void putAt(std::vector<std::byte>& data, std::size_t index, Value value) {
    std::memcpy(data.data() + index * sizeof value, &value, sizeof value);
}

template <class Value>
void copyComponents(const Image& from, Image& to) {
    const auto have = static_cast<std::size_t>(from.components),
               want = static_cast<std::size_t>(to.components);
    const std::size_t pixels = static_cast<std::size_t>(from.width) * static_cast<std::size_t>(from.height);
    const std::size_t colors = have < 3 ? 1 : 3, wantColors = want < 3 ? 1 : 3;
    const bool alpha = have == 2 || have == 4;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (std::size_t c = 0; c < want; ++c) {
            Value value = one<Value>();
            if (c < wantColors)
                value = valueAt<Value>(from.data.data(), pixel * have + std::min(c, colors - 1));
            else if (alpha)
                value = valueAt<Value>(from.data.data(), pixel * have + have - 1);
            putAt(to.data, pixel * want + c, value);
        }
}

template <class From, class To>
To converted(From from) {
    if constexpr (std::is_same_v<From, To>)
        return from;
    else if constexpr (std::is_same_v<To, float>)
        return static_cast<float>(from / static_cast<double>(one<From>()));
    else if constexpr (std::is_same_v<From, float>)
        return std::isnan(from) ? To{0}
                                : static_cast<To>(std::lround(std::clamp<double>(from, 0, 1) * one<To>()));
    else
        return static_cast<To>((from * static_cast<std::uint32_t>(one<To>()) + one<From>() / 2U) /
                               one<From>());
}

template <class From, class To>
void copyValues(const Image& from, Image& to) {
    const std::size_t count = from.data.size() / sizeof(From);
    for (std::size_t i = 0; i < count; ++i)
        putAt(to.data, i, converted<From, To>(valueAt<From>(from.data.data(), i)));
}

Image emptyOf(const Image& like, int components, Component type) {
    Image image{like.width, like.height, components, type, {}};
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
    return image;
}

}  // namespace

Image blankImage(std::uint64_t width, std::uint64_t height, Component type) {
    Image image{static_cast<int>(width), static_cast<int>(height), 4, type, {}};
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(height));
    return image;
}

Image withComponents(const Image& image, int components) {
    if (components == image.components) return image;
    Image result = emptyOf(image, components, image.type);
    withZeroOf(image.type, [&](auto zero) { copyComponents<decltype(zero)>(image, result); });
    return result;
}

Image withType(const Image& image, Component type) {
    if (type == image.type) return image;
    Image result = emptyOf(image, image.components, type);
    withZeroOf(image.type, [&](auto from) {
        withZeroOf(type, [&](auto to) { copyValues<decltype(from), decltype(to)>(image, result); });
    });
    return result;
}

bool isConsistent(const Image& image) {
    return image.width > 0 && image.height > 0 && image.components >= 1 && image.components <= 4 &&
           image.data.size() == image.rowBytes() * static_cast<std::size_t>(image.height);
}

}  // namespace glibra::image
