#include "image/png_writer.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "image/bytes.h"

namespace glibra::image {
namespace {

// PNG allows 2^31 - 1; a round figure below it.
constexpr std::size_t kLargestChunk = std::size_t{1} << 30;

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

void putChunk(std::vector<std::byte>& png, std::string_view type, std::span<const std::byte> content) {
    putBig32(png, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = png.size();
    const auto name = bytesOf(type);
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), content.begin(), content.end());
    putBig32(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

void putHeader(std::vector<std::byte>& png, const Image& image) {
    const auto signature = bytesOf("\x89PNG\r\n\x1a\n");
    png.insert(png.end(), signature.begin(), signature.end());
    constexpr std::array<std::uint8_t, 5> kColorTypes{0, 0, 4, 2, 6};  // by component count
    std::vector<std::byte> header;
    putBig32(header, static_cast<std::uint32_t>(image.width));
    putBig32(header, static_cast<std::uint32_t>(image.height));
    header.push_back(static_cast<std::byte>(image.type == Component::u8 ? 8 : 16));
    header.push_back(static_cast<std::byte>(kColorTypes.at(static_cast<std::size_t>(image.components))));
    header.insert(header.end(), 3, std::byte{0});  // deflate, adaptive filters, not interlaced
    putChunk(png, "IHDR", header);
}

bool isPrintable(char each) {
    return each >= ' ' && each <= '~';
}

void putText(std::vector<std::byte>& png, const std::string& keyword, const std::string& text) {
    if (keyword.empty() || keyword.size() > 79 || !std::all_of(keyword.begin(), keyword.end(), isPrintable))
        return;
    const bool plain =
        std::all_of(text.begin(), text.end(), [](char each) { return isPrintable(each) || each == '\n'; });
    // iTXt: not compressed, no language, no translated keyword.
    const std::string content = keyword + (plain ? std::string(1, '\0') : std::string(5, '\0')) + text;
    if (content.size() > kLargestChunk) return;
    putChunk(png, plain ? "tEXt" : "iTXt", bytesOf(content));
}

/// One row in PNG's byte order.
void copyRow(std::span<const std::byte> from, Component type, std::byte* to) {
    if (type == Component::u8 || std::endian::native == std::endian::big) {
        std::memcpy(to, from.data(), from.size());
        return;
    }
    for (std::size_t i = 0; i < from.size(); i += 2) {
        to[i] = from[i + 1];
        to[i + 1] = from[i];
    }
}

/// Subtracts the row above, byte by byte: filter type 2 of the PNG specification.
void subtractAbove(const std::byte* row, const std::byte* above, std::byte* to, std::size_t count) {
    const auto* a = reinterpret_cast<const std::uint8_t*>(row);
    const auto* b = reinterpret_cast<const std::uint8_t*>(above);
    auto* c = reinterpret_cast<std::uint8_t*>(to);
    for (std::size_t i = 0; i < count; ++i) c[i] = static_cast<std::uint8_t>(a[i] - b[i]);
}

/// The filtered rows, each with its filter type in front.
std::unique_ptr<std::byte[]> filteredRows(const Image& image, std::size_t size) {
    constexpr std::byte kNone{0}, kUp{2};
    const std::size_t rowBytes = image.rowBytes();
    auto rows = std::make_unique_for_overwrite<std::byte[]>(size);
    std::byte* to = rows.get();
    const bool swaps = image.type != Component::u8;
    auto row = std::make_unique_for_overwrite<std::byte[]>(swaps ? rowBytes : 0);
    auto above = std::make_unique_for_overwrite<std::byte[]>(swaps ? rowBytes : 0);
    for (int y = 0; y < image.height; ++y, to += 1 + rowBytes) {
        const std::byte* current = image.row(y).data();
        const std::byte* previous = y > 0 ? image.row(y - 1).data() : nullptr;
        if (swaps) {
            std::swap(row, above);
            copyRow(image.row(y), image.type, row.get());
            current = row.get();
            previous = above.get();
        }
        *to = y > 0 ? kUp : kNone;
        if (y > 0)
            subtractAbove(current, previous, to + 1, rowBytes);
        else
            std::memcpy(to + 1, current, rowBytes);
    }
    return rows;
}

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

}  // namespace

std::vector<std::byte> encodePng(const Image& image, const PngOptions& options) {
    if (image.width < 1 || image.height < 1 || image.components < 1 || image.components > 4) return {};
    if (image.type == Component::f32) return {};
    if (image.data.size() != image.rowBytes() * static_cast<std::size_t>(image.height)) return {};

    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(std::clamp(options.level, 1, 12)));
    if (!compressor) return {};
    const std::size_t size = (1 + image.rowBytes()) * static_cast<std::size_t>(image.height);
    const auto rows = filteredRows(image, size);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), size);
    const auto packed = std::make_unique_for_overwrite<std::byte[]>(bound);
    const std::size_t packedSize =
        libdeflate_zlib_compress(compressor.get(), rows.get(), size, packed.get(), bound);

    std::vector<std::byte> png;
    png.reserve(packedSize + 1024);
    putHeader(png, image);
    for (const auto& [keyword, text] : options.text) putText(png, keyword, text);
    for (std::size_t at = 0; at < packedSize; at += kLargestChunk)
        putChunk(png, "IDAT", {packed.get() + at, std::min(kLargestChunk, packedSize - at)});
    putChunk(png, "IEND", {});
    return png;
}

}  // namespace glibra::image
