// TGA (Truevision TGA File Format Specification, version 2.0). Of the 192 kinds of files that
// tests/image/variant_maker.cpp makes, OpenImageIO 2.4 gives wrong colours for 96: maps of 15, 16 and 32
// bits, grey with alpha, and attribute bits. stb_image 2.28 gives them for 100, such as rows from right to
// left, refuses 16, and reads files that are cut.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/image.h"

namespace glibra::image {
namespace {

using TargaPixel = std::array<std::uint8_t, 4>;  // red, green, blue, alpha

constexpr std::uint32_t kTargaHeader = 18, kMapped = 1, kTrueColor = 2, kGrey = 3;  // the last are kinds

/// What the extension area says of alpha (field 24); other numbers are as `useful`.
enum class TargaAlpha { none = 0, ignored = 1, kept = 2, useful = 3, premultiplied = 4 };

struct TargaHeader {
    std::uint32_t kind = 0, width = 0, height = 0, bits = 0;
    bool packed = false, rightToLeft = false, topDown = false;
    bool hasAttributes = false;  ///< 16-bit pixels have alpha
    std::uint32_t firstEntry = 0, entries = 0, entryBits = 0;
    std::size_t mapOffset = 0, dataOffset = 0;
};

bool isColorDepth(std::uint32_t bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

TargaAlpha alphaOfExtension(ByteSpan file) {
    constexpr std::size_t kFooter = 26, kExtension = 495, kAttributes = 494;
    constexpr std::string_view kSignature = "TRUEVISION-XFILE";
    if (file.size() < kTargaHeader + kFooter) return TargaAlpha::useful;
    const std::size_t footer = file.size() - kFooter;
    if (charactersOf(file).substr(footer + 8, kSignature.size()) != kSignature) return TargaAlpha::useful;
    const std::size_t at = little32(file, footer);
    if (at < kTargaHeader || at + kExtension > footer || little16(file, at) != kExtension)
        return TargaAlpha::useful;
    return static_cast<TargaAlpha>(octetAt(file, at + kAttributes));
}

Result<TargaHeader> readTargaHeader(ByteSpan file, const FileLabel& label) {
    if (file.size() < kTargaHeader) return damaged(label, "the file ends within the TGA header");
    const std::uint32_t type = octetAt(file, 2), flags = octetAt(file, 17);
    TargaHeader header{.kind = type & ~8U,
                       .width = little16(file, 12),
                       .height = little16(file, 14),
                       .bits = octetAt(file, 16),
                       .packed = (type & 8U) != 0,
                       .rightToLeft = (flags & 0x10U) != 0,
                       .topDown = (flags & 0x20U) != 0,
                       .hasAttributes = (flags & 0xfU) != 0};
    if (header.kind < kMapped || header.kind > kGrey)
        return damaged(label, fmt::format("unknown TGA type {}", type));
    if (header.width == 0 || header.height == 0)
        return damaged(label, "the picture has no pixels by its TGA header");
    if (header.kind == kTrueColor ? !isColorDepth(header.bits) : header.bits != 8 && header.bits != 16)
        return damaged(label, fmt::format("unknown TGA type {} with {} bits per pixel", type, header.bits));
    if (octetAt(file, 1) != 0) {
        header.firstEntry = little16(file, 3);
        header.entries = little16(file, 5);
        header.entryBits = octetAt(file, 7);
    }
    if (header.kind == kMapped && (header.entries == 0 || !isColorDepth(header.entryBits)))
        return damaged(
            label, fmt::format("its colour map has {} entries of {} bits", header.entries, header.entryBits));
    header.mapOffset = kTargaHeader + octetAt(file, 0);
    header.dataOffset = header.mapOffset + std::size_t{header.entries} * ((header.entryBits + 7) / 8);
    if (header.dataOffset >= file.size()) return damaged(label, "the file ends before its pixels");
    return header;
}

TargaPixel colorAt(ByteSpan file, std::size_t at, std::uint32_t bits, bool hasAttributes) {
    if (bits >= 24)
        return {octetAt(file, at + 2), octetAt(file, at + 1), octetAt(file, at),
                bits == 32 ? octetAt(file, at + 3) : std::uint8_t{255}};
    const std::uint32_t packed = little16(file, at);
    const auto component = [&](std::uint32_t mask) { return BitField<std::uint8_t>(mask, 255).of(packed); };
    return {component(0x7c00), component(0x03e0), component(0x001f),
            component(bits == 16 && hasAttributes ? 0x8000 : 0)};
}

/// Pixels of so many bytes without run lengths, as far as the file has them.
std::vector<std::byte> withoutRuns(ByteSpan file, std::size_t at, std::size_t bytes, std::size_t wanted) {
    std::vector<std::byte> plain;
    plain.reserve(wanted);
    while (plain.size() < wanted && at + 1 + bytes <= file.size()) {
        const std::size_t packet = octetAt(file, at++);
        const std::size_t length = std::min(((packet & 0x7fU) + 1) * bytes, wanted - plain.size());
        const bool isRun = (packet & 0x80U) != 0;
        const std::size_t have = isRun ? length : std::min(length, (file.size() - at) / bytes * bytes);
        const ByteSpan from = file.subspan(at, isRun ? bytes : have);
        for (std::size_t done = 0; done < have; done += from.size())
            plain.insert(plain.end(), from.begin(), from.end());
        at += isRun ? bytes : length;
    }
    return plain;
}

}  // namespace

Result<Image> decodeTarga(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto read = readTargaHeader(file, label);
    if (!read) return read.diagnostics;
    const TargaHeader& header = *read;
    if (auto refused = checkPacked(header.width, header.height, 4, file.size(), limits, label))
        return *std::move(refused);
    const std::size_t width = header.width, height = header.height, bytes = (header.bits + 7) / 8;
    const std::vector<std::byte> plain =
        header.packed ? withoutRuns(file, header.dataOffset, bytes, width * height * bytes)
                      : std::vector<std::byte>();
    const ByteSpan data = header.packed ? ByteSpan(plain) : file.subspan(header.dataOffset);
    if (data.size() / bytes < width * height) return endsEarly(label, data.size() / bytes / width, height);

    const TargaAlpha alpha = alphaOfExtension(file);
    Image image = blankImage(width, height, Component::u8);
    for (std::size_t i = 0, at = 0; i < width * height; ++i, at += bytes) {
        TargaPixel pixel{};
        if (header.kind == kTrueColor) {
            pixel = colorAt(data, at, header.bits, header.hasAttributes);
        } else if (header.kind == kGrey) {
            pixel.fill(octetAt(data, at));
            pixel[3] = bytes == 2 ? octetAt(data, at + 1) : std::uint8_t{255};
        } else {
            const std::uint32_t index = bytes == 2 ? little16(data, at) : octetAt(data, at);
            if (index < header.firstEntry || index - header.firstEntry >= header.entries)
                return damaged(
                    label, fmt::format("a pixel has the colour {}, but the colour map has {} to {}", index,
                                       header.firstEntry, header.firstEntry + header.entries - 1));
            const std::size_t entry = std::size_t{index - header.firstEntry} * ((header.entryBits + 7) / 8);
            pixel = colorAt(file, header.mapOffset + entry, header.entryBits, false);
        }
        if (alpha == TargaAlpha::none || alpha == TargaAlpha::ignored) pixel[3] = 255;
        const std::size_t x = header.rightToLeft ? width - 1 - i % width : i % width,
                          y = header.topDown ? i / width : height - 1 - i / width;
        std::memcpy(image.data.data() + 4 * (y * width + x), pixel.data(), 4);
    }
    if (alpha == TargaAlpha::premultiplied) unassociateAlpha(image);
    return image;
}

}  // namespace glibra::image
