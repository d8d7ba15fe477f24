#include "image/bmp/bmp_header.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/bytes.h"

namespace glibra::image {
namespace {

constexpr std::size_t kFileHeader = 14;

/// Size, bits and compression, from either family of headers. False if they contradict each other.
bool readGeometry(ByteSpan file, std::uint32_t headerSize, BmpHeader& header, std::uint32_t& colorsUsed) {
    if (headerSize == 12) {
        header.width = little16(file, 18);
        header.height = little16(file, 20);
        header.bits = little16(file, 24);
        return header.width > 0 && header.height > 0;
    }
    const auto width = static_cast<std::int32_t>(little32(file, 18));
    const auto height = static_cast<std::int32_t>(little32(file, 22));
    header.width = static_cast<std::uint32_t>(std::max(width, 0));
    header.topDown = height < 0;
    header.height = height < 0 ? 0U - static_cast<std::uint32_t>(height) : static_cast<std::uint32_t>(height);
    header.bits = little16(file, 28);
    header.compression = static_cast<BmpCompression>(little32(file, 30));
    colorsUsed = little32(file, 46);
    return header.width > 0 && header.height > 0;
}

bool isKnown(const BmpHeader& header) {
    switch (header.compression) {
        case BmpCompression::none:
            return header.bits == 1 || header.bits == 4 || header.bits == 8 || header.bits == 16 ||
                   header.bits == 24 || header.bits == 32;
        case BmpCompression::rle8:
            return header.bits == 8;
        case BmpCompression::rle4:
            return header.bits == 4;
        case BmpCompression::bitFields:
        case BmpCompression::alphaBitFields:
            return header.bits == 16 || header.bits == 32;
        case BmpCompression::jpeg:
        case BmpCompression::png:
            return true;
    }
    return false;
}

/// Sets the masks. `at` is the start of the palette and is moved past masks that follow the header. False if
/// the file ends before.
bool readMasks(ByteSpan file, std::uint32_t headerSize, BmpHeader& header, std::size_t& at) {
    if (header.compression == BmpCompression::none) {
        // Masks in the header apply only with bit fields; the fourth byte of plain 32-bit pixels has no
        // meaning.
        if (header.bits == 16) header.masks = {0x7c00, 0x03e0, 0x001f, 0};
        if (header.bits == 32) header.masks = {0xff0000, 0x00ff00, 0x0000ff, 0};
        return true;
    }
    if (header.compression != BmpCompression::bitFields &&
        header.compression != BmpCompression::alphaBitFields)
        return true;
    std::size_t count = header.compression == BmpCompression::alphaBitFields ? 4 : 3;
    std::size_t from = at;
    if (headerSize >= 52) {  // the masks are part of the header
        count = headerSize >= 56 ? 4 : 3;
        from = kFileHeader + 40;
    } else {
        at += 4 * count;
    }
    if (file.size() < from + 4 * count) return false;
    for (std::size_t i = 0; i < count; ++i) header.masks.at(i) = little32(file, from + 4 * i);
    if (header.bits != 32) header.masks[3] = 0;  // language, 8.2: only 32-bit pixels have alpha
    return true;
}

void readPalette(ByteSpan file, std::uint32_t headerSize, std::uint32_t colorsUsed, std::size_t at,
                 BmpHeader& header) {
    if (header.bits > 8 || header.bits == 0) return;
    const std::size_t entryBytes = headerSize == 12 ? 3 : 4;
    const std::size_t most = std::size_t{1} << header.bits;
    std::size_t count = colorsUsed == 0 ? most : std::min<std::size_t>(colorsUsed, most);
    count = std::min(count, (header.dataOffset - at) /
                                entryBytes);  // old writers store fewer entries than the header allows
    for (std::size_t i = 0; i < count; ++i) {
        const ByteSpan entry = file.subspan(at + i * entryBytes, 3);
        header.palette.push_back({std::to_integer<std::uint8_t>(entry[2]),
                                  std::to_integer<std::uint8_t>(entry[1]),
                                  std::to_integer<std::uint8_t>(entry[0])});
    }
}

}  // namespace

Result<BmpHeader> readBmpHeader(ByteSpan file, const FileLabel& label) {
    const auto tooShort = [&] { return damaged(label, "the file ends within the BMP header"); };
    if (file.size() < kFileHeader + 4) return tooShort();
    const std::uint32_t headerSize = little32(file, 14);
    constexpr std::array<std::uint32_t, 7> kHeaderSizes{12, 40, 52, 56, 64, 108, 124};
    if (std::find(kHeaderSizes.begin(), kHeaderSizes.end(), headerSize) == kHeaderSizes.end())
        return damaged(label, fmt::format("unknown BMP header of {} bytes", headerSize));
    std::size_t at = kFileHeader + headerSize;
    if (file.size() < at) return tooShort();

    BmpHeader header;
    std::uint32_t colorsUsed = 0;
    if (!readGeometry(file, headerSize, header, colorsUsed))
        return damaged(label, "the picture has no pixels by its BMP header");
    // OS/2 2.x uses the numbers 3 and 4 for its own compressions.
    const auto code = static_cast<std::uint32_t>(header.compression);
    if (!isKnown(header) || (headerSize == 64 && code >= 3))
        return damaged(label,
                       fmt::format("unknown BMP compression {} with {} bits per pixel", code, header.bits));
    if (!readMasks(file, headerSize, header, at)) return tooShort();

    header.dataOffset = little32(file, 10);
    if (header.dataOffset < at)
        return damaged(
            label, fmt::format("the pixel data start at byte {}, inside the BMP header", header.dataOffset));
    if (header.dataOffset >= file.size())
        return damaged(label,
                       fmt::format("the pixel data start at byte {} of {}", header.dataOffset, file.size()));
    readPalette(file, headerSize, colorsUsed, at, header);
    return header;
}

}  // namespace glibra::image
