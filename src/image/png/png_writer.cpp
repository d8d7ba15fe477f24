#include "image/png/png_writer.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "image/bytes.h"
#include "image/convert.h"
#include "image/png/png_data.h"

namespace glibra::image {
namespace {

// PNG allows 2^31 - 1; this is a round number below it.
constexpr std::size_t kLargestChunk = std::size_t{1} << 30;

std::span<const std::byte> textBytes(std::string_view text) {
    return std::as_bytes(std::span(text));
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
    putPngChunk(png, plain ? "tEXt" : "iTXt", textBytes(content));
}

}  // namespace

void putPngChunk(std::vector<std::byte>& png, std::string_view type, std::span<const std::byte> content) {
    putBig32(png, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = png.size();
    const auto name = textBytes(type);
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), content.begin(), content.end());
    putBig32(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

void putPngHeader(std::vector<std::byte>& png, const Image& image) {
    const auto signature = textBytes("\x89PNG\r\n\x1a\n");
    png.insert(png.end(), signature.begin(), signature.end());
    constexpr std::array<std::uint8_t, 5> kColorTypes{0, 0, 4, 2, 6};  // by component count
    std::vector<std::byte> header;
    putBig32(header, static_cast<std::uint32_t>(image.width));
    putBig32(header, static_cast<std::uint32_t>(image.height));
    header.push_back(static_cast<std::byte>(image.type == Component::u8 ? 8 : 16));
    header.push_back(static_cast<std::byte>(kColorTypes.at(static_cast<std::size_t>(image.components))));
    header.insert(header.end(), 3, std::byte{0});  // deflate, adaptive filters, not interlaced
    putPngChunk(png, "IHDR", header);
}

std::vector<std::byte> encodePng(const Image& image, const PngOptions& options) {
    if (!isConsistent(image) || image.type == Component::f32) return {};
    const std::vector<std::byte> data = packPngData(image, std::clamp(options.level, 0, 12), options.threads);
    if (data.empty()) return {};

    std::vector<std::byte> png;
    png.reserve(data.size() + 1024);
    putPngHeader(png, image);
    for (const auto& [keyword, text] : options.text) putText(png, keyword, text);
    for (std::size_t at = 0; at < data.size(); at += kLargestChunk)
        putPngChunk(png, "IDAT", std::span(data).subspan(at, std::min(kLargestChunk, data.size() - at)));
    putPngChunk(png, "IEND", {});
    return png;
}

}  // namespace glibra::image
