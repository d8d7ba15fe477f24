#include "image/dds/dds_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>

#include "image/bytes.h"

namespace glibra::image {
namespace {

constexpr std::size_t kDdsHeader = 128, kDdsExtension = 20;

using Layout = std::array<DdsBits, 4>;

/// One row per kind of pixel that has a number: DXGI_FORMAT, and D3DFORMAT in place of a name.
struct DdsKind {
    std::uint32_t dxgi;  ///< 0: none
    std::uint32_t d3d;   ///< 0: none
    std::uint32_t pixelBits;
    Layout bits;
    DdsNumber number;
};

constexpr Layout kFour32{{{0, 32}, {32, 32}, {64, 32}, {96, 32}}}, kThree32{{{0, 32}, {32, 32}, {64, 32}}},
    kTwo32{{{0, 32}, {32, 32}}}, kOne32{{{0, 32}}}, kFour16{{{0, 16}, {16, 16}, {32, 16}, {48, 16}}},
    kTwo16{{{0, 16}, {16, 16}}}, kOne16{{{0, 16}}}, kFour8{{{0, 8}, {8, 8}, {16, 8}, {24, 8}}},
    kTwo8{{{0, 8}, {8, 8}}}, kOne8{{{0, 8}}}, kTen{{{0, 10}, {10, 10}, {20, 10}, {30, 2}}},
    kBgra8{{{16, 8}, {8, 8}, {0, 8}, {24, 8}}}, kBgr8{{{16, 8}, {8, 8}, {0, 8}}};

constexpr std::array kDdsKinds{
    DdsKind{2, 116, 128, kFour32, DdsNumber::floating},
    DdsKind{3, 0, 128, kFour32, DdsNumber::whole},
    DdsKind{4, 0, 128, kFour32, DdsNumber::signedWhole},
    DdsKind{6, 0, 96, kThree32, DdsNumber::floating},
    DdsKind{7, 0, 96, kThree32, DdsNumber::whole},
    DdsKind{8, 0, 96, kThree32, DdsNumber::signedWhole},
    DdsKind{10, 113, 64, kFour16, DdsNumber::floating},
    DdsKind{11, 36, 64, kFour16, DdsNumber::fraction},
    DdsKind{12, 0, 64, kFour16, DdsNumber::whole},
    DdsKind{13, 110, 64, kFour16, DdsNumber::signedFraction},
    DdsKind{14, 0, 64, kFour16, DdsNumber::signedWhole},
    DdsKind{16, 115, 64, kTwo32, DdsNumber::floating},
    DdsKind{17, 0, 64, kTwo32, DdsNumber::whole},
    DdsKind{18, 0, 64, kTwo32, DdsNumber::signedWhole},
    DdsKind{24, 0, 32, kTen, DdsNumber::fraction},
    DdsKind{25, 0, 32, kTen, DdsNumber::whole},
    DdsKind{28, 0, 32, kFour8, DdsNumber::fraction},
    DdsKind{29, 0, 32, kFour8, DdsNumber::fraction},
    DdsKind{30, 0, 32, kFour8, DdsNumber::whole},
    DdsKind{31, 0, 32, kFour8, DdsNumber::signedFraction},
    DdsKind{32, 0, 32, kFour8, DdsNumber::signedWhole},
    DdsKind{34, 112, 32, kTwo16, DdsNumber::floating},
    DdsKind{35, 0, 32, kTwo16, DdsNumber::fraction},
    DdsKind{36, 0, 32, kTwo16, DdsNumber::whole},
    DdsKind{37, 0, 32, kTwo16, DdsNumber::signedFraction},
    DdsKind{38, 0, 32, kTwo16, DdsNumber::signedWhole},
    DdsKind{41, 114, 32, kOne32, DdsNumber::floating},
    DdsKind{42, 0, 32, kOne32, DdsNumber::whole},
    DdsKind{43, 0, 32, kOne32, DdsNumber::signedWhole},
    DdsKind{49, 0, 16, kTwo8, DdsNumber::fraction},
    DdsKind{50, 0, 16, kTwo8, DdsNumber::whole},
    DdsKind{51, 0, 16, kTwo8, DdsNumber::signedFraction},
    DdsKind{52, 0, 16, kTwo8, DdsNumber::signedWhole},
    DdsKind{54, 111, 16, kOne16, DdsNumber::floating},
    DdsKind{56, 0, 16, kOne16, DdsNumber::fraction},
    DdsKind{57, 0, 16, kOne16, DdsNumber::whole},
    DdsKind{58, 0, 16, kOne16, DdsNumber::signedFraction},
    DdsKind{59, 0, 16, kOne16, DdsNumber::signedWhole},
    DdsKind{61, 0, 8, kOne8, DdsNumber::fraction},
    DdsKind{62, 0, 8, kOne8, DdsNumber::whole},
    DdsKind{63, 0, 8, kOne8, DdsNumber::signedFraction},
    DdsKind{64, 0, 8, kOne8, DdsNumber::signedWhole},
    DdsKind{65, 0, 8, {{{}, {}, {}, {0, 8}}}, DdsNumber::fraction},
    DdsKind{85, 0, 16, {{{11, 5}, {5, 6}, {0, 5}, {}}}, DdsNumber::fraction},
    DdsKind{86, 0, 16, {{{10, 5}, {5, 5}, {0, 5}, {15, 1}}}, DdsNumber::fraction},
    DdsKind{87, 0, 32, kBgra8, DdsNumber::fraction},
    DdsKind{88, 0, 32, kBgr8, DdsNumber::fraction},
    DdsKind{91, 0, 32, kBgra8, DdsNumber::fraction},
    DdsKind{93, 0, 32, kBgr8, DdsNumber::fraction},
    DdsKind{115, 0, 16, {{{8, 4}, {4, 4}, {0, 4}, {12, 4}}}, DdsNumber::fraction},
};

/// A kind of compressed blocks: its name, or the DXGI_FORMATs from `first` to `last`: without a type, sRGB
/// and plain, which hold the same bytes.
struct DdsBlockKind {
    std::string_view name;      ///< empty: none
    std::uint32_t first, last;  ///< 0: none
    std::uint32_t bytes, parts, dxgi;
    bool isSigned = false, premultiplied = false;
};

constexpr std::array kDdsBlockKinds{
    DdsBlockKind{"DXT1", 70, 72, 8, 0, kDxgiBc1},
    DdsBlockKind{"DXT3", 73, 75, 16, 0, kDxgiBc2},
    DdsBlockKind{"DXT5", 76, 78, 16, 0, kDxgiBc3},
    DdsBlockKind{"DXT2", 0, 0, 16, 0, kDxgiBc2, false, true},
    DdsBlockKind{"DXT4", 0, 0, 16, 0, kDxgiBc3, false, true},
    DdsBlockKind{"BC4U", 79, 80, 8, 1, 0},
    DdsBlockKind{"ATI1", 0, 0, 8, 1, 0},
    DdsBlockKind{"BC4S", 81, 81, 8, 1, 0, true},
    DdsBlockKind{"BC5U", 82, 83, 16, 2, 0},
    DdsBlockKind{"ATI2", 0, 0, 16, 2, 0},
    DdsBlockKind{"BC5S", 84, 84, 16, 2, 0, true},
    DdsBlockKind{"", 94, 95, 16, 0, kDxgiBc6},
    DdsBlockKind{"", 97, 99, 16, 0, kDxgiBc7},
};

template <class Is>
bool takeBlocks(const Is& is, DdsHeader& header) {
    const auto* const kind = std::find_if(kDdsBlockKinds.begin(), kDdsBlockKinds.end(), is);
    if (kind == kDdsBlockKinds.end()) return false;
    header.blockBytes = kind->bytes;
    header.blockParts = kind->parts;
    header.blockDxgi = kind->dxgi;
    header.premultiplied |= kind->premultiplied;
    if (kind->isSigned) header.number = DdsNumber::signedFraction;
    return true;
}

/// False unless the bits of a mask are adjacent.
bool bitsOfMask(std::uint32_t mask, DdsBits& bits) {
    if (mask == 0) return true;
    bits.first = static_cast<std::uint32_t>(std::countr_zero(mask));
    bits.count = static_cast<std::uint32_t>(std::popcount(mask));
    return mask >> bits.first == (bits.count == 32 ? 0xffffffffU : (1U << bits.count) - 1);
}

constexpr std::uint32_t kAlphaPixels = 1, kAlphaOnly = 2, kName = 4, kPalette = 0x20, kColors = 0x40,
                        kLuminance = 0x20000, kSigned = 0x80000;

/// The pixels by the masks of the header. False if they are no pixels.
bool readDdsMasks(ByteSpan file, std::uint32_t flags, DdsHeader& header) {
    header.pixelBits = little32(file, 88);
    const std::uint32_t bits = header.pixelBits;
    if (bits != 8 && bits != 16 && bits != 24 && bits != 32) return false;
    const std::uint32_t most = bits == 32 ? 0xffffffffU : (1U << bits) - 1;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool wanted = i == 3 ? (flags & (kAlphaPixels | kAlphaOnly)) != 0
                                   : (flags & (kColors | kLuminance | kSigned)) != 0;
        const std::uint32_t mask = wanted ? little32(file, 92 + 4 * i) : 0;
        if ((mask & ~most) != 0 || !bitsOfMask(mask, header.bits.at(i))) return false;
        used |= mask;
    }
    if ((flags & kSigned) != 0) header.number = DdsNumber::signedFraction;
    return used != 0;
}

bool takeKind(const DdsKind* kind, DdsHeader& header) {
    if (kind == kDdsKinds.end()) return false;
    header.pixelBits = kind->pixelBits;
    header.bits = kind->bits;
    header.number = kind->number;
    return true;
}

/// The kind of pixels. Empty, or what is wrong with it.
std::string readPixelKind(ByteSpan file, DdsHeader& header) {
    const std::uint32_t flags = little32(file, 80);
    if ((flags & kName) == 0) {
        if ((flags & kPalette) != 0) return "its colours are in a palette, which is not read";
        return readDdsMasks(file, flags, header)
                   ? std::string()
                   : fmt::format("unknown DDS pixels of {} bits with the masks {:x} {:x} {:x} {:x}",
                                 little32(file, 88), little32(file, 92), little32(file, 96),
                                 little32(file, 100), little32(file, 104));
    }
    const std::uint32_t number = little32(file, 84);
    const std::string_view name(reinterpret_cast<const char*>(file.data()) + 84, 4);
    if (name != "DX10") {
        if (takeBlocks([&](const DdsBlockKind& each) { return each.name == name; }, header)) return {};
        const auto* const kind = std::find_if(kDdsKinds.begin(), kDdsKinds.end(), [&](const DdsKind& each) {
            return each.d3d != 0 && each.d3d == number;
        });
        if (takeKind(kind, header)) return {};
        return fmt::format("unknown DDS pixels, kind {}", number);
    }
    header.dataOffset = kDdsHeader + kDdsExtension;
    if (file.size() < header.dataOffset) return "the file ends within the DDS header";
    const std::uint32_t dxgi = little32(file, kDdsHeader), dimension = little32(file, kDdsHeader + 4);
    constexpr std::uint32_t kVolume = 4, kPremultiplied = 2;
    if (dimension == kVolume) return "it is a volume";
    header.premultiplied = (little32(file, kDdsHeader + 16) & 7U) == kPremultiplied;
    if (dxgi != 0 &&
        takeBlocks([&](const DdsBlockKind& each) { return each.first <= dxgi && dxgi <= each.last; }, header))
        return {};
    const auto* const kind = std::find_if(kDdsKinds.begin(), kDdsKinds.end(), [&](const DdsKind& each) {
        return each.dxgi != 0 && each.dxgi == dxgi;
    });
    if (takeKind(kind, header)) return {};
    return fmt::format("unknown DDS pixels, DXGI format {}", dxgi);
}

}  // namespace

Result<DdsHeader> readDdsHeader(ByteSpan file, const FileLabel& label) {
    constexpr std::uint32_t kHasPitch = 8, kIsVolume = 0x200000;
    if (file.size() < kDdsHeader) return damaged(label, "the file ends within the DDS header");
    if (little32(file, 4) != 124 || little32(file, 76) != 32)
        return damaged(label, "its DDS header is damaged");
    DdsHeader header;
    header.height = little32(file, 12);
    header.width = little32(file, 16);
    header.dataOffset = kDdsHeader;
    if (header.width == 0 || header.height == 0)
        return damaged(label, "the picture has no pixels by its DDS header");
    if ((little32(file, 112) & kIsVolume) != 0) return damaged(label, "it is a volume");
    if (const std::string problem = readPixelKind(file, header); !problem.empty())
        return damaged(label, problem);

    if (header.blockBytes > 0) {
        header.rowBytes = (std::uint64_t{header.width} + 3) / 4 * header.blockBytes;
        return header;
    }
    header.isGrey = header.bits[1].count == 0 && header.bits[2].count == 0 && header.bits[0].count > 0;
    // Rows are not padded, but some writers pad them to 4 bytes; other numbers in this place are not to be
    // trusted.
    header.rowBytes = (std::uint64_t{header.width} * header.pixelBits + 7) / 8;
    const std::uint64_t pitch = little32(file, 20);
    if ((little32(file, 8) & kHasPitch) != 0 && pitch > header.rowBytes && pitch < header.rowBytes + 4 &&
        pitch % 4 == 0)
        header.rowBytes = pitch;
    return header;
}

}  // namespace glibra::image
