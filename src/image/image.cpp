#include "image/image.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "image/bytes.h"

namespace glibra::image {
namespace {

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
            Value value = kOne<Value>;
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
        return static_cast<float>(from / static_cast<double>(kOne<From>));
    else if constexpr (std::is_same_v<From, float>)
        return std::isnan(from) ? To{0}
                                : static_cast<To>(std::lround(std::clamp<double>(from, 0, 1) * kOne<To>));
    else
        return static_cast<To>((from * static_cast<std::uint32_t>(kOne<To>) + kOne<From> / 2U) / kOne<From>);
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

namespace {

template <class Value>
void divideColors(Image& image) {
    for (std::size_t at = 0; at + 4 * sizeof(Value) <= image.data.size(); at += 4 * sizeof(Value)) {
        std::byte* const pixel = image.data.data() + at;
        const auto alpha = valueAt<Value>(pixel, 3);
        if (alpha == 0 || alpha == kOne<Value>) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            auto color = valueAt<Value>(pixel, c);
            if constexpr (std::is_integral_v<Value>)
                color = static_cast<Value>(std::min<std::uint64_t>(
                    (std::uint64_t{color} * kOne<Value> + alpha / 2U) / alpha, kOne<Value>));
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
            const auto turned = static_cast<Value>(kOne<Value> - valueAt<Value>(component, 0));
            std::memcpy(component, &turned, sizeof turned);
        }
}

template <class Value>
bool hasOtherThanOpaque(const Image& image) {
    const auto components = static_cast<std::size_t>(image.components);
    const std::size_t count = image.data.size() / sizeof(Value);
    for (std::size_t i = components - 1; i < count; i += components)
        if (valueAt<Value>(image.data.data(), i) != kOne<Value>) return true;
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

Image upright(Image image, unsigned orientation) {
    if (orientation < 2 || orientation > 8) return image;
    const bool swapsAxes = orientation >= 5;
    const bool fromRight = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool fromBottom = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    Image turned{image.width, image.height, image.components, image.type, {}};
    if (swapsAxes) std::swap(turned.width, turned.height);
    turned.data.resize(image.data.size());
    const std::size_t pixel = static_cast<std::size_t>(image.components) * bytesOf(image.type);
    const std::byte* from = image.data.data();
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column, from += pixel) {
            int x = swapsAxes ? row : column, y = swapsAxes ? column : row;
            if (fromRight) x = turned.width - 1 - x;
            if (fromBottom) y = turned.height - 1 - y;
            std::memcpy(turned.data.data() + static_cast<std::size_t>(y) * turned.rowBytes() +
                            static_cast<std::size_t>(x) * pixel,
                        from, pixel);
        }
    return turned;
}

bool isOneColor(const Image& image) {
    const std::size_t pixel = static_cast<std::size_t>(image.components) * bytesOf(image.type);
    // All pixels are equal if and only if each byte equals the byte one pixel later.
    return image.data.size() <= pixel ||
           std::memcmp(image.data.data(), image.data.data() + pixel, image.data.size() - pixel) == 0;
}

NonFinite countNonFinite(const Image& image) {
    NonFinite found;
    if (image.type != Component::f32 || !isConsistent(image)) return found;
    const std::size_t rowValues = image.rowBytes() / sizeof(float);
    for (int y = 0; y < image.height; ++y) {
        const std::byte* row = image.row(y).data();
        for (std::size_t i = 0; i < rowValues; ++i) {
            const auto value = valueAt<float>(row, i);
            if (std::isfinite(value)) continue;
            if (found.nan + found.infinite == 0) {
                found.x = static_cast<int>(i / static_cast<std::size_t>(image.components));
                found.y = y;
            }
            ++(std::isnan(value) ? found.nan : found.infinite);
        }
    }
    return found;
}

static constexpr int kRgbBytes = 3;  // of a pixel

Bounds differenceOf(const Image& a, const Image& b) {
    Bounds bounds{a.width, a.height, 0, 0};
    for (int y = 0; y < a.height; ++y) {
        const std::span<const std::byte> rowA = a.row(y), rowB = b.row(y);
        if (std::memcmp(rowA.data(), rowB.data(), rowA.size()) == 0) continue;
        const auto first = std::mismatch(rowA.begin(), rowA.end(), rowB.begin()).first - rowA.begin();
        const auto last = rowA.rend() - std::mismatch(rowA.rbegin(), rowA.rend(), rowB.rbegin()).first;
        bounds.left = std::min(bounds.left, static_cast<int>(first) / kRgbBytes);
        bounds.right = std::max(bounds.right, (static_cast<int>(last) + kRgbBytes - 1) / kRgbBytes);
        bounds.top = std::min(bounds.top, y);
        bounds.bottom = y + 1;
    }
    return bounds;
}

Image partOf(const Image& image, const Bounds& bounds) {
    Image part{bounds.right - bounds.left, bounds.bottom - bounds.top, kRgbBytes, Component::u8, {}};
    part.data.reserve(part.rowBytes() * static_cast<std::size_t>(part.height));
    for (int y = bounds.top; y < bounds.bottom; ++y) {
        const std::span<const std::byte> row =
            image.row(y).subspan(static_cast<std::size_t>(bounds.left) * kRgbBytes, part.rowBytes());
        part.data.insert(part.data.end(), row.begin(), row.end());
    }
    return part;
}

void flipRows(TexelBlock& block) {
    const std::size_t rowBytes = static_cast<std::size_t>(block.width) *
                                 static_cast<std::size_t>(block.components) * bytesOf(block.type);
    const auto height = static_cast<std::size_t>(block.height);
    const std::size_t slices = block.data.size() / (rowBytes * height);
    for (std::size_t slice = 0; slice < slices; ++slice)
        for (std::size_t y = 0; y < height / 2; ++y) {
            std::byte* const first = block.data.data() + slice * height * rowBytes;
            std::swap_ranges(first + y * rowBytes, first + (y + 1) * rowBytes,
                             first + (height - 1 - y) * rowBytes);
        }
}

void decodeSrgb(TexelBlock& block) {
    Image image{block.width, block.height * block.depth * block.faces, block.components, block.type,
                std::move(block.data)};
    image = withType(image, Component::f32);
    const std::size_t count = image.data.size() / sizeof(float);
    const auto components = static_cast<std::size_t>(block.components);
    for (std::size_t i = 0; i < count; ++i) {
        if (components == 4 && i % 4 == 3) continue;
        const auto encoded = static_cast<double>(valueAt<float>(image.data.data(), i));
        const auto value = static_cast<float>(linearOfSrgb(encoded));
        std::memcpy(image.data.data() + i * sizeof value, &value, sizeof value);
    }
    block.type = Component::f32;
    block.data = std::move(image.data);
}

}  // namespace glibra::image
