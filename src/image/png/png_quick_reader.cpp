#include "image/png/png_quick_reader.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "image/png/png_chunks.h"

namespace glibra::image {
namespace {

struct FreeDecompressor {
    void operator()(libdeflate_decompressor* each) const { libdeflate_free_decompressor(each); }
};

/// The predictor of PNG's filter type 4 (PNG specification, 9.4).
std::uint8_t paeth(int left, int above, int corner) {
    const int toLeft = std::abs(above - corner), toAbove = std::abs(left - corner);
    const int toCorner = std::abs(left + above - 2 * corner);
    if (toLeft <= toAbove && toLeft <= toCorner) return static_cast<std::uint8_t>(left);
    return static_cast<std::uint8_t>(toAbove <= toCorner ? above : corner);
}

/// Undoes a row's filter in place; `above` is the row before, or zeros. False for an unknown filter.
template <std::size_t Pixel>
bool unfilter(std::uint8_t type, std::uint8_t* row, const std::uint8_t* above, std::size_t count) {
    const auto add = [](std::uint8_t a, int b) { return static_cast<std::uint8_t>(a + b); };
    switch (type) {
        case 0:
            return true;
        case 1:
            for (std::size_t i = Pixel; i < count; ++i) row[i] = add(row[i], row[i - Pixel]);
            return true;
        case 2:
            for (std::size_t i = 0; i < count; ++i) row[i] = add(row[i], above[i]);
            return true;
        case 3:
            for (std::size_t i = 0; i < Pixel; ++i) row[i] = add(row[i], above[i] / 2);
            for (std::size_t i = Pixel; i < count; ++i) row[i] = add(row[i], (row[i - Pixel] + above[i]) / 2);
            return true;
        case 4:
            for (std::size_t i = 0; i < Pixel; ++i) row[i] = add(row[i], above[i]);
            for (std::size_t i = Pixel; i < count; ++i)
                row[i] = add(row[i], paeth(row[i - Pixel], above[i], above[i - Pixel]));
            return true;
        default:
            return false;
    }
}

/// RGB to RGBA, a word at a time.
void addAlpha(const std::uint8_t* rgb, std::size_t width, std::byte* to) {
    const std::uint32_t opaque = std::endian::native == std::endian::little ? 0xff000000U : 0x000000ffU;
    for (std::size_t x = 0; x + 1 < width; ++x, rgb += 3, to += 4) {
        std::uint32_t word = 0;
        std::memcpy(&word, rgb, 4);  // the fourth byte is the next pixel's
        word |= opaque;
        std::memcpy(to, &word, 4);
    }
    std::memcpy(to, rgb, 3);
    to[3] = std::byte{255};
}

/// Unpacks the pixels to `rows`, each row behind its filter's type; false if they are not exactly as long.
bool inflate(const PngChunks& chunks, std::span<std::byte> rows) {
    std::vector<std::byte> joined;
    std::span<const std::byte> packed = chunks.data.front();
    if (chunks.data.size() > 1) {
        for (const auto& each : chunks.data) joined.insert(joined.end(), each.begin(), each.end());
        packed = joined;
    }
    const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
        libdeflate_alloc_decompressor());
    return decompressor &&
           libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), rows.data(),
                                      rows.size(), nullptr) == LIBDEFLATE_SUCCESS;
}

/// The rows are at the end of the memory that the pixels go to; each is out of the way before its place is
/// written, since pixels are never shorter than their packed form.
template <std::size_t Pixel>
bool unpackRows(const std::byte* rows, std::size_t width, std::size_t height, std::byte* to) {
    const std::size_t count = width * Pixel;
    std::vector<std::uint8_t> row(count), above(count);
    for (std::size_t y = 0; y < height; ++y, rows += count + 1, to += 4 * width) {
        std::memcpy(row.data(), rows + 1, count);
        if (!unfilter<Pixel>(std::to_integer<std::uint8_t>(*rows), row.data(), above.data(), count))
            return false;
        if constexpr (Pixel == 4)
            std::memcpy(to, row.data(), count);
        else
            addAlpha(row.data(), width, to);
        std::swap(row, above);
    }
    return true;
}

}  // namespace

std::optional<Image> decodeUsualPng(std::span<const std::byte> file) {
    constexpr int kRgb = 2, kRgba = 6;
    const auto chunks = pngChunks(file);
    if (!chunks || chunks->bitDepth != 8 || chunks->interlaced || chunks->transparentColor) return {};
    if (chunks->colorType != kRgb && chunks->colorType != kRgba) return {};
    const std::size_t width = chunks->width, height = chunks->height;
    if (width == 0 || height == 0) return {};
    const std::size_t pixel = chunks->colorType == kRgb ? 3 : 4;
    Image image{static_cast<int>(width), static_cast<int>(height), 4, Component::u8, {}};
    const std::size_t size = image.rowBytes() * height, packedSize = (width * pixel + 1) * height;
    image.data.resize(std::max(size, packedSize));
    const auto rows = std::span(image.data).last(packedSize);
    if (!inflate(*chunks, rows)) return {};
    const bool done = pixel == 3 ? unpackRows<3>(rows.data(), width, height, image.data.data())
                                 : unpackRows<4>(rows.data(), width, height, image.data.data());
    image.data.resize(size);
    return done ? std::optional(std::move(image)) : std::nullopt;
}

}  // namespace glibra::image
