#include "suite/report/packed_pixels.h"

#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace glibra::suite {
namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

std::vector<std::byte> rowsMinusAbove(const image::Image& picture) {
    std::vector<std::byte> bytes = picture.data;
    const std::size_t rowBytes = picture.rowBytes();
    for (std::size_t i = bytes.size(); i-- > rowBytes;)
        bytes[i] = static_cast<std::byte>(std::to_integer<unsigned>(bytes[i]) -
                                          std::to_integer<unsigned>(bytes[i - rowBytes]));
    return bytes;
}

/// The colours without alpha if alpha is 1 everywhere, or nothing.
std::optional<image::Image> withoutAlpha(const image::Image& picture) {
    if (picture.components != 4) return std::nullopt;
    const std::size_t valueBytes = image::bytesOf(picture.type), colorBytes = 3 * valueBytes;
    constexpr std::array<std::byte, 2> kOneOf16{std::byte{255}, std::byte{255}};
    constexpr auto kOneOf32 = std::bit_cast<std::array<std::byte, 4>>(1.F);
    const std::byte* one = picture.type == image::Component::f32 ? kOneOf32.data() : kOneOf16.data();
    image::Image opaque{picture.width, picture.height, 3, picture.type, {}};
    opaque.data.resize(picture.data.size() / 4 * 3);
    const std::byte* from = picture.data.data();
    for (std::size_t to = 0; to < opaque.data.size(); to += colorBytes, from += 4 * valueBytes) {
        if (std::memcmp(from + colorBytes, one, valueBytes) != 0) return std::nullopt;
        std::memcpy(opaque.data.data() + to, from, colorBytes);
    }
    return opaque;
}

}  // namespace

std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t at) {
            return at < bytes.size() ? std::to_integer<std::uint32_t>(bytes[at]) : 0U;
        };
        const std::uint32_t group = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
        const std::size_t digits = std::min<std::size_t>(bytes.size() - i, 3) + 1;
        for (std::size_t digit = 0; digit < 4; ++digit)
            text += digit < digits ? kDigits[group >> (18 - 6 * digit) & 63U] : '=';
    }
    return text;
}

std::string packedPixels(const image::Image& picture) {
    if (const std::optional<image::Image> opaque = withoutAlpha(picture)) return packedPixels(*opaque);
    constexpr std::array kTypes{"u8", "u16", "f32"};
    constexpr int kLevel = 1;  // fast: a report may have hundreds of failures
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kLevel));
    const std::vector<std::byte> bytes = rowsMinusAbove(picture);
    std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return fmt::format(R"({{"width":{},"height":{},"components":{},"type":"{}","data":"{}"}})", picture.width,
                       picture.height, picture.components, kTypes.at(static_cast<std::size_t>(picture.type)),
                       base64(packed));
}

}  // namespace glibra::suite
