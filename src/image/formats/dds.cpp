// DDS (Microsoft, "Programming guide for DDS"). Of the formats with a number OpenImageIO 2.4 reads only
// blocks, and of these no BC4 and BC5 with a sign; it searches 20 seconds and more for the pixels of some
// masks, and gives alpha alone as grey. stb_image reads no DDS. So pixels, and blocks of components, are read
// here; other blocks are handed to the module as files that have nothing else.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/image.h"

namespace glibra::image {
namespace {

constexpr std::size_t kDdsHeader = 128, kDdsExtension = 20;

/// What the bits of a component mean, by the letters of the table below: 0..1, -1..1, whole numbers without
/// and with a sign, and floats of 16 or 32 bits.
enum class DdsNumber : char {
    fraction = 'n',
    signedFraction = 's',
    whole = 'u',
    signedWhole = 'i',
    floating = 'f'
};

/// Where a component lies within a pixel, counted from its lowest bit.
struct DdsBits {
    std::uint32_t first = 0, count = 0;  ///< count 0: the pixels do not have the component
};
using DdsLayout = std::array<DdsBits, 4>;  // red, green, blue, alpha

struct DdsHeader {
    std::uint32_t width = 0, height = 0;
    std::uint64_t rowBytes = 0;    ///< of the pixels, or of a row of blocks of 4 x 4 pixels
    std::uint32_t pixelBits = 0;   ///< 0: blocks of 4 x 4 pixels
    std::uint32_t blockBytes = 0;  ///< of such a block
    std::uint32_t blockParts = 0;  ///< components in parts of 8 bytes (BC4: 1, BC5: 2); 0: of other kinds
    std::uint32_t blockDxgi = 0;   ///< of other kinds: their DXGI_FORMAT, one for each way to read blocks
    DdsLayout bits{};
    DdsNumber number = DdsNumber::fraction;
    bool premultiplied = false;  ///< colours are multiplied by alpha
    std::size_t dataOffset = kDdsHeader;
};

/// DXGI_FORMATs whose components have equal numbers of bits, from `first` on: a letter for each one, or a
/// point.
struct DdsFamily {
    std::uint32_t first, components, bits;
    std::string_view numbers;
};
constexpr std::array kDdsFamilies{
    DdsFamily{1, 4, 32, ".fui"},  DdsFamily{5, 3, 32, ".fui"},   DdsFamily{9, 4, 16, ".fnusi"},
    DdsFamily{15, 2, 32, ".fui"}, DdsFamily{27, 4, 8, ".nnusi"}, DdsFamily{33, 2, 16, ".fnusi"},
    DdsFamily{40, 1, 32, ".fui"}, DdsFamily{48, 2, 8, ".nusi"},  DdsFamily{53, 1, 16, ".f.nusi"},
    DdsFamily{60, 1, 8, ".nusi"},
};

/// Other DXGI_FORMATs.
struct DdsOther {
    std::uint32_t dxgi, pixelBits;
    DdsLayout bits;
    DdsNumber number = DdsNumber::fraction;
};
constexpr DdsLayout kTen{{{0, 10}, {10, 10}, {20, 10}, {30, 2}}}, kBgra{{{16, 8}, {8, 8}, {0, 8}, {24, 8}}},
    kBgr{{{16, 8}, {8, 8}, {0, 8}}};
constexpr std::array kDdsOthers{
    DdsOther{24, 32, kTen},
    DdsOther{25, 32, kTen, DdsNumber::whole},
    DdsOther{65, 8, {{{}, {}, {}, {0, 8}}}},
    DdsOther{85, 16, {{{11, 5}, {5, 6}, {0, 5}, {}}}},
    DdsOther{86, 16, {{{10, 5}, {5, 5}, {0, 5}, {15, 1}}}},
    DdsOther{87, 32, kBgra},
    DdsOther{88, 32, kBgr},
    DdsOther{91, 32, kBgra},
    DdsOther{93, 32, kBgr},
    DdsOther{115, 16, {{{8, 4}, {4, 4}, {0, 4}, {12, 4}}}},
};

/// D3DFORMATs that stand in place of a name, and the DXGI_FORMATs of the same pixels.
constexpr std::array<std::array<std::uint32_t, 2>, 8> kDdsOldNumbers{
    {{36, 11}, {110, 13}, {111, 54}, {112, 34}, {113, 10}, {114, 41}, {115, 16}, {116, 2}}};

/// A kind of compressed blocks: its name, or the DXGI_FORMATs from `first` to `last`: without a type, sRGB
/// and plain, which hold the same bytes.
struct DdsBlockKind {
    std::string_view name;      ///< empty: none
    std::uint32_t first, last;  ///< 0: none
    std::uint32_t bytes, parts;
    std::uint32_t dxgi = 0;  ///< 0: of parts
    DdsNumber number = DdsNumber::fraction;
    bool premultiplied = false;
};
constexpr std::array kDdsBlockKinds{
    DdsBlockKind{"DXT1", 70, 72, 8, 0, 71},
    DdsBlockKind{"DXT3", 73, 75, 16, 0, 74},
    DdsBlockKind{"DXT5", 76, 78, 16, 0, 77},
    DdsBlockKind{"DXT2", 0, 0, 16, 0, 74, DdsNumber::fraction, true},
    DdsBlockKind{"DXT4", 0, 0, 16, 0, 77, DdsNumber::fraction, true},
    DdsBlockKind{"BC4U", 79, 80, 8, 1},
    DdsBlockKind{"ATI1", 0, 0, 8, 1},
    DdsBlockKind{"BC4S", 81, 81, 8, 1, 0, DdsNumber::signedFraction},
    DdsBlockKind{"BC5U", 82, 83, 16, 2},
    DdsBlockKind{"ATI2", 0, 0, 16, 2},
    DdsBlockKind{"BC5S", 84, 84, 16, 2, 0, DdsNumber::signedFraction},
    DdsBlockKind{"", 94, 95, 16, 0, 95},
    DdsBlockKind{"", 97, 99, 16, 0, 98},
};

template <class Is>
bool takeBlocks(const Is& is, DdsHeader& header) {
    const auto* const kind = std::find_if(kDdsBlockKinds.begin(), kDdsBlockKinds.end(), is);
    if (kind == kDdsBlockKinds.end()) return false;
    header.blockBytes = kind->bytes;
    header.blockParts = kind->parts;
    header.blockDxgi = kind->dxgi;
    header.number = kind->number;
    header.premultiplied |= kind->premultiplied;
    return true;
}

/// The pixels of a DXGI_FORMAT. False if it is not known.
bool takePixels(std::uint32_t dxgi, DdsHeader& header) {
    for (const DdsFamily& each : kDdsFamilies) {
        if (dxgi < each.first || dxgi - each.first >= each.numbers.size()) continue;
        const char number = each.numbers[dxgi - each.first];
        if (number == '.') return false;
        header.number = static_cast<DdsNumber>(number);
        header.pixelBits = each.components * each.bits;
        for (std::uint32_t c = 0; c < each.components; ++c) header.bits.at(c) = {c * each.bits, each.bits};
        return true;
    }
    const auto* const other = std::ranges::find(kDdsOthers, dxgi, &DdsOther::dxgi);
    if (other == kDdsOthers.end()) return false;
    header.pixelBits = other->pixelBits;
    header.bits = other->bits;
    header.number = other->number;
    return true;
}

/// The pixels by the masks of the header, whose bits must be adjacent. False if they are no pixels.
bool takeMasks(ByteSpan file, std::uint32_t flags, DdsHeader& header) {
    constexpr std::uint32_t kAlpha = 1 | 2, kColors = 0x40 | 0x20000 | 0x80000, kSigned = 0x80000;
    const std::uint32_t bits = header.pixelBits = little32(file, 88);
    if (bits != 8 && bits != 16 && bits != 24 && bits != 32) return false;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::uint64_t mask =
            (flags & (i == 3 ? kAlpha : kColors)) != 0 ? little32(file, 92 + 4 * i) : 0;
        if (mask == 0) continue;
        header.bits.at(i) = {static_cast<std::uint32_t>(std::countr_zero(mask)),
                             static_cast<std::uint32_t>(std::popcount(mask))};
        if (mask >> bits != 0 || !std::has_single_bit((mask >> header.bits.at(i).first) + 1)) return false;
        ++used;
    }
    if ((flags & kSigned) != 0) header.number = DdsNumber::signedFraction;
    return used != 0;
}

/// The kind of pixels. Empty, or what is wrong with it.
std::string readPixelKind(ByteSpan file, DdsHeader& header) {
    constexpr std::uint32_t kName = 4, kPalette = 0x20, kVolume = 4, kPremultiplied = 2;
    const std::uint32_t flags = little32(file, 80), number = little32(file, 84);
    if ((flags & kName) == 0) {
        if ((flags & kPalette) != 0) return "its colours are in a palette, which is not read";
        return takeMasks(file, flags, header)
                   ? std::string()
                   : fmt::format("unknown DDS pixels of {} bits with the masks {:x} {:x} {:x} {:x}",
                                 little32(file, 88), little32(file, 92), little32(file, 96),
                                 little32(file, 100), little32(file, 104));
    }
    const std::string_view name = charactersOf(file).substr(84, 4);
    if (name != "DX10") {
        if (takeBlocks([&](const DdsBlockKind& each) { return each.name == name; }, header)) return {};
        for (const auto& [old, dxgi] : kDdsOldNumbers)
            if (old == number && takePixels(dxgi, header)) return {};
        return fmt::format("unknown DDS pixels, kind {}", number);
    }
    header.dataOffset += kDdsExtension;
    if (file.size() < header.dataOffset) return "the file ends within the DDS header";
    const std::uint32_t dxgi = little32(file, kDdsHeader);
    if (little32(file, kDdsHeader + 4) == kVolume) return "it is a volume";
    header.premultiplied = (little32(file, kDdsHeader + 16) & 7U) == kPremultiplied;
    const auto isIn = [&](const DdsBlockKind& each) { return each.first <= dxgi && dxgi <= each.last; };
    if (dxgi != 0 && (takeBlocks(isIn, header) || takePixels(dxgi, header))) return {};
    return fmt::format("unknown DDS pixels, DXGI format {}", dxgi);
}

Result<DdsHeader> readDdsHeader(ByteSpan file, const FileLabel& label) {
    constexpr std::uint32_t kHasPitch = 8, kIsVolume = 0x200000;
    if (file.size() < kDdsHeader) return damaged(label, "the file ends within the DDS header");
    if (little32(file, 4) != 124 || little32(file, 76) != 32)
        return damaged(label, "its DDS header is damaged");
    DdsHeader header;
    header.height = little32(file, 12);
    header.width = little32(file, 16);
    if (header.width == 0 || header.height == 0)
        return damaged(label, "the picture has no pixels by its DDS header");
    if ((little32(file, 112) & kIsVolume) != 0) return damaged(label, "it is a volume");
    if (const std::string problem = readPixelKind(file, header); !problem.empty())
        return damaged(label, problem);
    // Rows are not padded, but some writers pad them to 4 bytes; other numbers in this place are not to be
    // trusted.
    const std::uint64_t pitch = little32(file, 20);
    header.rowBytes = header.blockBytes > 0 ? (std::uint64_t{header.width} + 3) / 4 * header.blockBytes
                                            : (std::uint64_t{header.width} * header.pixelBits + 7) / 8;
    if (header.blockBytes == 0 && (little32(file, 8) & kHasPitch) != 0 && pitch > header.rowBytes &&
        pitch < header.rowBytes + 4 && pitch % 4 == 0)
        header.rowBytes = pitch;
    return header;
}

Component typeOfPixels(const DdsHeader& header) {
    std::uint32_t most = 0;
    for (const DdsBits& each : header.bits) most = std::max(most, each.count);
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

template <class Value>
Value componentOf(std::uint32_t raw, std::uint32_t count, DdsNumber number) {
    const std::uint64_t all = (std::uint64_t{1} << count) - 1, sign = std::uint64_t{1} << (count - 1);
    if constexpr (std::is_integral_v<Value>)
        return static_cast<Value>((raw * std::uint64_t{std::numeric_limits<Value>::max()} + all / 2) / all);
    else if (number == DdsNumber::floating)
        return count == 16 ? ofHalf(raw) : std::bit_cast<float>(raw);
    const double value = (raw & sign) != 0 ? static_cast<double>(raw) - static_cast<double>(all) - 1 : raw;
    if (number == DdsNumber::fraction) return static_cast<Value>(raw / static_cast<double>(all));
    if (number == DdsNumber::whole || (number == DdsNumber::signedFraction && count == 1))
        return static_cast<Value>(raw);
    if (number == DdsNumber::signedWhole) return static_cast<Value>(value);
    return static_cast<Value>(std::max(-1., value / static_cast<double>(sign - 1)));
}

template <class Value>
void readDdsPixels(ByteSpan data, const DdsHeader& header, Image& image) {
    const std::size_t bytes = header.pixelBits / 8;
    const auto has = [&](std::size_t c) { return header.bits.at(c).count > 0; };
    const bool isGrey = has(0) && !has(1) && !has(2);
    std::byte* to = image.data.data();
    for (std::size_t y = 0; y < header.height; ++y)
        for (std::size_t x = 0; x < header.width; ++x, to += 4 * sizeof(Value)) {
            const ByteSpan from =
                data.subspan(y * static_cast<std::size_t>(header.rowBytes) + x * bytes, bytes);
            std::array<Value, 4> pixel{};
            pixel[3] = kOne<Value>;
            for (std::size_t c = 0; c < 4; ++c)
                if (has(c))
                    pixel.at(c) = componentOf<Value>(bitsAt(from, header.bits.at(c)), header.bits.at(c).count,
                                                     header.number);
            if (isGrey) pixel[1] = pixel[2] = pixel[0];
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
    const std::uint64_t indices = little16(block, 2) | std::uint64_t{little32(block, 4)} << 16U;
    std::array<double, 16> pixels{};
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels.at(i) = values.at(indices >> (3 * i) & 7U);
    return pixels;
}

/// Blocks whose components lie in parts of 8 bytes.
template <class Value>
void readBlockParts(ByteSpan data, const DdsHeader& header, Image& image) {
    constexpr std::size_t kSide = 4, kPart = 8;
    const bool isSigned = header.number == DdsNumber::signedFraction, isGrey = header.blockParts == 1;
    for (std::size_t top = 0; top < header.height; top += kSide)
        for (std::size_t left = 0; left < header.width; left += kSide) {
            const ByteSpan block = data.subspan(top / kSide * static_cast<std::size_t>(header.rowBytes) +
                                                left / kSide * header.blockBytes);
            const auto red = componentBlock(block, isSigned);
            const auto green = isGrey ? red : componentBlock(block.subspan(kPart), isSigned);
            for (std::size_t i = 0; i < red.size(); ++i) {
                const std::size_t x = left + i % kSide, y = top + i / kSide;
                if (x >= header.width || y >= header.height) continue;
                std::array<Value, 4> pixel{};
                const std::array<double, 4> values{red.at(i), green.at(i), isGrey ? red.at(i) : 0, 1};
                for (std::size_t c = 0; c < 4; ++c)
                    pixel.at(c) = static_cast<Value>(
                        std::is_integral_v<Value> ? std::round(values.at(c) * kOne<Value>) : values.at(c));
                std::memcpy(image.data.data() + (y * header.width + x) * sizeof pixel, pixel.data(),
                            sizeof pixel);
            }
        }
}

/// BC1 to BC3 by their names, others by their number, so that the module sees each in one form.
std::vector<std::byte> onlyBlocks(ByteSpan file, const DdsHeader& header, std::size_t length) {
    const std::uint32_t dxgi = header.blockDxgi;
    const std::string_view name = dxgi == 71 ? "DXT1" : dxgi == 74 ? "DXT3" : dxgi == 77 ? "DXT5" : "DX10";
    const bool isNumbered = name == "DX10";
    std::vector<std::byte> blocks(file.begin(), file.begin() + kDdsHeader);
    blocks.resize(kDdsHeader + (isNumbered ? kDdsExtension : 0));
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (unsigned i = 0; i < 4; ++i) blocks[at + i] = static_cast<std::byte>(value >> (8 * i) & 255U);
    };
    constexpr std::uint32_t kPlainFlags = 0x1007, kFourCc = 4, kTexture = 0x1000, kTexture2D = 3;
    put(8, kPlainFlags);
    for (const std::size_t each : {20U, 24U, 28U, 112U}) put(each, 0);  // length, depth, levels, faces
    put(80, kFourCc);
    std::memcpy(blocks.data() + 84, name.data(), name.size());
    put(108, kTexture);
    if (isNumbered) {
        put(kDdsHeader, dxgi);
        put(kDdsHeader + 4, kTexture2D);
        put(kDdsHeader + 12, 1);
    }
    const auto data = file.subspan(header.dataOffset, length);
    blocks.insert(blocks.end(), data.begin(), data.end());
    return blocks;
}

}  // namespace

Result<DdsContent> decodeDds(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto read = readDdsHeader(file, label);
    if (!read) return read.diagnostics;
    const DdsHeader& header = *read;
    const bool isPacked = header.blockBytes > 0, isForModule = isPacked && header.blockParts == 0;
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

    DdsContent content{.image = std::nullopt, .blocks = {}, .premultiplied = header.premultiplied};
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
