#include <fmt/format.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "image/convert.h"
#include "suite/report_files.h"

namespace glibra::suite {
namespace {

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

/// RFC 4648, section 4.
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

std::vector<std::byte> rowsMinusAbove(const image::Image& picture) {
    std::vector<std::byte> bytes = picture.data;
    const std::size_t rowBytes = picture.rowBytes();
    for (std::size_t i = bytes.size(); i-- > rowBytes;)
        bytes[i] = static_cast<std::byte>(std::to_integer<unsigned>(bytes[i]) -
                                          std::to_integer<unsigned>(bytes[i - rowBytes]));
    return bytes;
}

bool isOpaque(const image::Image& picture) {
    if (picture.components != 4) return false;
    const image::Image opaque = image::withComponents(image::withComponents(picture, 3), 4);
    return opaque.data == picture.data;
}

const char* typeName(image::Component type) {
    switch (type) {
        case image::Component::u8:
            return "u8";
        case image::Component::u16:
            return "u16";
        case image::Component::f32:
            break;
    }
    return "f32";
}

}  // namespace

std::string packedPixels(const image::Image& picture) {
    if (isOpaque(picture)) return packedPixels(image::withComponents(picture, 3));
    constexpr int kLevel = 6;
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(kLevel));
    const std::vector<std::byte> bytes = rowsMinusAbove(picture);
    std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return fmt::format(R"({{"width":{},"height":{},"components":{},"type":"{}","data":"{}"}})", picture.width,
                       picture.height, picture.components, typeName(picture.type), base64(packed));
}

}  // namespace glibra::suite
