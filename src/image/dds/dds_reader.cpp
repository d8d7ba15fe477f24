#include "image/dds/dds_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

#include "image/alpha.h"
#include "image/bytes.h"
#include "image/convert.h"
#include "image/dds/dds_header.h"

namespace glibra::image {
namespace {

std::uint32_t widestOf(const DdsHeader& header) {
    std::uint32_t most = 0;
    for (const DdsBits& each : header.bits) most = std::max(most, each.count);
    return most;
}

Component typeOfPixels(const DdsHeader& header) {
    const std::uint32_t most = widestOf(header);
    if (header.number != DdsNumber::fraction || most > 16) return Component::f32;
    return most > 8 ? Component::u16 : Component::u8;
}

/// The bits of a component, at most 32, which lie in at most five bytes.
std::uint32_t bitsAt(ByteSpan pixel, const DdsBits& bits) {
    std::uint64_t value = 0;
    for (std::size_t i = std::min(pixel.size(), std::size_t{bits.first} / 8 + 5); i-- > bits.first / 8;)
        value = value << 8U | octetAt(pixel, i);
    value >>= bits.first % 8;
    return static_cast<std::uint32_t>(value & ((std::uint64_t{1} << bits.count) - 1));
}

/// IEEE 754, 16 bits.
float ofHalf(std::uint32_t half) {
    const auto exponent = static_cast<int>(half >> 10U & 31U);
    const auto fraction = static_cast<float>(half & 1023U);
    float value = 0;
    if (exponent == 31)
        value =
            fraction == 0 ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
    else
        value = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(fraction + 1024, exponent - 25);
    return (half & 0x8000U) != 0 ? -value : value;
}

float numberOf(std::uint32_t raw, std::uint32_t count, DdsNumber number) {
    const std::uint64_t all = (std::uint64_t{1} << count) - 1, sign = std::uint64_t{1} << (count - 1);
    const double value = (raw & sign) != 0 ? static_cast<double>(raw) - static_cast<double>(all) - 1 : raw;
    switch (number) {
        case DdsNumber::fraction:
            return static_cast<float>(raw / static_cast<double>(all));
        case DdsNumber::signedFraction:
            return count == 1 ? static_cast<float>(raw)
                              : static_cast<float>(std::max(-1., value / static_cast<double>(sign - 1)));
        case DdsNumber::whole:
            return static_cast<float>(raw);
        case DdsNumber::signedWhole:
            return static_cast<float>(value);
        case DdsNumber::floating:
            return count == 16 ? ofHalf(raw) : std::bit_cast<float>(raw);
    }
    return 0;
}

template <class Value>
Value componentOf(ByteSpan pixel, const DdsBits& bits, DdsNumber number) {
    const std::uint32_t raw = bitsAt(pixel, bits);
    if constexpr (std::is_integral_v<Value>) {
        const std::uint64_t all = (std::uint64_t{1} << bits.count) - 1;
        return static_cast<Value>((raw * std::uint64_t{std::numeric_limits<Value>::max()} + all / 2) / all);
    } else {
        return numberOf(raw, bits.count, number);
    }
}

template <class Value>
void readDdsPixels(ByteSpan data, const DdsHeader& header, Image& image) {
    const std::size_t bytes = header.pixelBits / 8;
    std::byte* to = image.data.data();
    for (std::size_t y = 0; y < header.height; ++y)
        for (std::size_t x = 0; x < header.width; ++x, to += 4 * sizeof(Value)) {
            const ByteSpan from =
                data.subspan(y * static_cast<std::size_t>(header.rowBytes) + x * bytes, bytes);
            std::array<Value, 4> pixel{};
            pixel[3] = std::is_integral_v<Value> ? std::numeric_limits<Value>::max() : Value{1};
            for (std::size_t c = 0; c < 4; ++c)
                if (header.bits.at(c).count > 0)
                    pixel.at(c) = componentOf<Value>(from, header.bits.at(c), header.number);
            if (header.isGrey) pixel[1] = pixel[2] = pixel[0];
            std::memcpy(to, pixel.data(), sizeof pixel);
        }
}

/// One component of a block of 4 x 4 pixels, row by row: BC4 (Microsoft, "Texture Block Compression in
/// Direct3D 11"). 0..1, or -1..1 with a sign.
std::array<double, 16> componentBlock(ByteSpan block, bool isSigned) {
    const auto endOf = [&](std::size_t at) {
        const int value =
            isSigned ? std::max(-127, int{std::bit_cast<std::int8_t>(block[at])}) : int{octetAt(block, at)};
        return value / (isSigned ? 127. : 255.);
    };
    std::array<double, 8> values{endOf(0), endOf(1)};
    const bool hasEight = values[0] > values[1];
    const int steps = hasEight ? 7 : 5;
    for (int i = 1; i < steps; ++i)
        values.at(static_cast<std::size_t>(i + 1)) = ((steps - i) * values[0] + i * values[1]) / steps;
    if (!hasEight) {
        values[6] = isSigned ? -1 : 0;
        values[7] = 1;
    }
    std::uint64_t indices = 0;
    for (std::size_t i = 8; i-- > 2;) indices = indices << 8U | octetAt(block, i);
    std::array<double, 16> pixels{};
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels.at(i) = values.at(indices >> (3 * i) & 7U);
    return pixels;
}

/// Blocks whose components lie in parts of 8 bytes.
template <class Value>
void readBlockParts(ByteSpan data, const DdsHeader& header, Image& image) {
    constexpr bool isWhole = std::is_integral_v<Value>;
    constexpr std::size_t kSide = 4, kPart = 8;
    constexpr double most = isWhole ? std::numeric_limits<Value>::max() : 1;
    for (std::size_t top = 0; top < header.height; top += kSide)
        for (std::size_t left = 0; left < header.width; left += kSide) {
            const ByteSpan block = data.subspan(top / kSide * static_cast<std::size_t>(header.rowBytes) +
                                                left / kSide * header.blockBytes);
            std::array<std::array<double, 16>, 2> parts{};
            for (std::size_t c = 0; c < header.blockParts; ++c)
                parts.at(c) = componentBlock(block.subspan(c * kPart, kPart),
                                             header.number == DdsNumber::signedFraction);
            if (header.blockParts == 1) parts[1] = parts[0];
            for (std::size_t i = 0; i < parts[0].size(); ++i) {
                const std::size_t x = left + i % kSide, y = top + i / kSide;
                if (x >= header.width || y >= header.height) continue;
                const double blue = header.blockParts == 1 ? parts[0].at(i) : 0;
                std::array<Value, 4> pixel{};
                const std::array<double, 4> values{parts[0].at(i), parts[1].at(i), blue, 1};
                for (std::size_t c = 0; c < 4; ++c)
                    pixel.at(c) =
                        static_cast<Value>(isWhole ? std::round(values.at(c) * most) : values.at(c));
                std::memcpy(image.data.data() + (y * header.width + x) * sizeof pixel, pixel.data(),
                            sizeof pixel);
            }
        }
}

/// BC1 to BC3 by their names, others by their number, so that the module sees each in one form.
DdsBlocks onlyBlocks(ByteSpan file, const DdsHeader& header, std::size_t length) {
    constexpr std::size_t kHeader = 128, kExtension = 20;
    const std::uint32_t dxgi = header.blockDxgi;
    const std::string_view name = dxgi == kDxgiBc1   ? "DXT1"
                                  : dxgi == kDxgiBc2 ? "DXT3"
                                  : dxgi == kDxgiBc3 ? "DXT5"
                                                     : "DX10";
    const bool isNumbered = name == "DX10";
    DdsBlocks blocks;
    blocks.premultiplied = header.premultiplied;
    blocks.file.assign(file.begin(), file.begin() + kHeader);
    blocks.file.resize(kHeader + (isNumbered ? kExtension : 0));
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (unsigned i = 0; i < 4; ++i)
            blocks.file[at + i] = static_cast<std::byte>(value >> (8 * i) & 255U);
    };
    constexpr std::uint32_t kPlainFlags = 0x1007, kFourCc = 4, kTexture = 0x1000, kTexture2D = 3;
    put(8, kPlainFlags);
    for (const std::size_t each : {20U, 24U, 28U, 112U}) put(each, 0);  // length, depth, levels, faces
    put(80, kFourCc);
    std::memcpy(blocks.file.data() + 84, name.data(), name.size());
    put(108, kTexture);
    if (isNumbered) {
        put(kHeader, dxgi);
        put(kHeader + 4, kTexture2D);
        put(kHeader + 12, 1);
    }
    const auto data = file.subspan(header.dataOffset, length);
    blocks.file.insert(blocks.file.end(), data.begin(), data.end());
    return blocks;
}

}  // namespace

Result<DdsContent> decodeDds(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto read = readDdsHeader(file, label);
    if (!read) return read.diagnostics;
    const DdsHeader& header = *read;
    const bool isPacked = header.blockBytes > 0;
    const bool isForModule = isPacked && header.blockParts == 0;
    const Component type = isForModule ? Component::u8 : typeOfPixels(header);
    if (auto tooLarge = checkSize(header.width, header.height, 4 * bytesOf(type), limits, label))
        return *std::move(tooLarge);
    const ByteSpan data = file.subspan(header.dataOffset);
    const std::uint64_t rows = isPacked ? (std::uint64_t{header.height} + 3) / 4 : header.height;
    // Some writers omit the padding of the last row.
    const std::uint64_t lastRow =
        isPacked ? header.rowBytes : (std::uint64_t{header.width} * header.pixelBits + 7) / 8;
    if (data.size() < header.rowBytes * (rows - 1) + lastRow)
        return endsEarly(label, data.size() / header.rowBytes * (isPacked ? 4 : 1), header.height);

    DdsContent content;
    if (isForModule) {
        content.blocks = onlyBlocks(file, header, static_cast<std::size_t>(header.rowBytes * rows));
        return content;
    }
    content.image = blankImage(header.width, header.height, type);
    withZeroOf(type, [&](auto zero) {
        if (isPacked)
            readBlockParts<decltype(zero)>(data, header, *content.image);
        else
            readDdsPixels<decltype(zero)>(data, header, *content.image);
    });
    if (header.premultiplied) unassociateAlpha(*content.image);
    return content;
}

}  // namespace glibra::image
