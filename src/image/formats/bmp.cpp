// BMP files. Layouts: Microsoft's BITMAPFILEHEADER, BITMAPCOREHEADER, BITMAPINFOHEADER, BITMAPV4HEADER and
// BITMAPV5HEADER, IBM's 64-byte OS/2 2.x header.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "image/bytes.h"
#include "image/formats/readers.h"
#include "image/image.h"

namespace glibra::image {
namespace {

enum class BmpCompression : std::uint32_t {
    none = 0,
    rle8 = 1,
    rle4 = 2,
    bitFields = 3,
    jpeg = 4,
    png = 5,
    alphaBitFields = 6
};

struct BmpHeader {
    std::uint32_t width = 0, height = 0;
    bool topDown = false;
    std::uint32_t bits = 0;  ///< bits per pixel: 1, 4, 8, 16, 24, 32 (0 for a wrapped JPEG or PNG)
    BmpCompression compression = BmpCompression::none;
    std::array<std::uint32_t, 4> masks{};              ///< red, green, blue, alpha of 16- and 32-bit pixels
    std::vector<std::array<std::uint8_t, 3>> palette;  ///< red, green, blue
    std::size_t dataOffset = 0;                        ///< within the file
};

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

/// Reads and checks everything before the pixels. Errors: file-E04.
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

/// Red, green, blue, alpha.
using BmpPixel = std::array<std::uint8_t, 4>;

/// RLE4 and RLE8 (Microsoft, "Bitmap Compression"): fills `pixels` (top row first) by the commands in `data`;
/// pixels that no command sets are colors[0], those beyond the end of a row are dropped. Returns the number
/// of complete rows: all of them also after an end-of-picture command, fewer if the data end early.
std::uint64_t decodeRunLengths(ByteSpan data, const BmpHeader& header, std::span<const BmpPixel> colors,
                               std::span<BmpPixel> pixels) {
    std::fill(pixels.begin(), pixels.end(), colors[0]);
    std::uint64_t x = 0, y = 0;  // of the next pixel, in the order of the file
    const auto byteAt = [&](std::size_t at) { return std::uint32_t{octetAt(data, at)}; };
    // `from` points at the only byte of a run, or at the first byte of literal pixels.
    const auto put = [&](std::size_t from, std::uint32_t count, bool isLiteral) {
        for (std::uint32_t i = 0; i < count; ++i, ++x) {
            if (x >= header.width || y >= header.height) continue;
            const std::uint32_t byte = byteAt(from + (!isLiteral ? 0 : header.bits == 8 ? i : i / 2));
            const std::uint64_t row = header.topDown ? y : header.height - 1 - y;
            pixels[row * header.width + x] =
                colors[header.bits == 8 ? byte : byte >> (i % 2 == 0 ? 4U : 0U) & 15U];
        }
    };
    for (std::size_t at = 0; at + 2 <= data.size() && y < header.height;) {
        const std::uint32_t count = byteAt(at), command = byteAt(at + 1);
        at += 2;
        if (count > 0) {
            put(at - 1, count, false);
        } else if (command == 0) {
            x = 0;
            ++y;
        } else if (command == 1) {
            return header.height;
        } else if (command == 2) {
            if (at + 2 > data.size()) break;
            x += byteAt(at);
            y += byteAt(at + 1);
            at += 2;
        } else {
            const std::size_t bytes = header.bits == 8 ? command : (command + 1) / 2;
            if (at + bytes > data.size()) break;
            put(at, command, true);
            at += bytes + bytes % 2;
        }
    }
    const bool isFull = y >= header.height || (y + 1 == header.height && x >= header.width);
    return isFull ? header.height : y;
}

using Field = BitField<std::uint8_t>;

/// Entries that the palette lacks have alpha 0, by which `findStrays` finds them.
std::vector<BmpPixel> colorsOf(const BmpHeader& header) {
    std::vector<BmpPixel> colors(std::size_t{1} << header.bits, BmpPixel{});
    for (std::size_t i = 0; i < header.palette.size(); ++i) {
        std::copy(header.palette[i].begin(), header.palette[i].end(), colors[i].begin());
        colors[i][3] = 255;
    }
    return colors;
}

/// Makes pixels black whose colour the palette lacks. file-W16 if there are any.
Diagnostics findStrays(const BmpHeader& header, const FileLabel& label, std::span<BmpPixel> pixels) {
    if (header.bits > 8 || header.palette.size() == std::size_t{1} << header.bits) return {};
    std::uint64_t strays = 0;
    for (BmpPixel& each : pixels)
        if (each[3] == 0) {
            each[3] = 255;
            ++strays;
        }
    if (strays == 0) return {};
    return {diagnose("file-W16",
                     fmt::format("'{}': {} pixels have colours that the palette lacks; they are black",
                                 label.name, strays),
                     label.place)};
}

void indexedRow(ByteSpan from, std::uint32_t bits, std::span<const BmpPixel> colors, std::span<BmpPixel> to) {
    const std::uint32_t perByte = 8 / bits, mask = (1U << bits) - 1;
    for (std::size_t x = 0; x < to.size(); ++x) {
        const auto byte = std::to_integer<std::uint32_t>(from[x / perByte]);
        const auto shift = 8 - bits * (1 + static_cast<std::uint32_t>(x % perByte));
        to[x] = colors[byte >> shift & mask];
    }
}

void directRow(ByteSpan from, std::span<BmpPixel> to) {
    for (std::size_t x = 0; x < to.size(); ++x)
        to[x] = {std::to_integer<std::uint8_t>(from[3 * x + 2]),
                 std::to_integer<std::uint8_t>(from[3 * x + 1]), std::to_integer<std::uint8_t>(from[3 * x]),
                 255};
}

void fieldRow(ByteSpan from, std::uint32_t bits, const std::array<Field, 4>& fields, std::span<BmpPixel> to) {
    for (std::size_t x = 0; x < to.size(); ++x) {
        const std::uint32_t pixel = bits == 16 ? little16(from, 2 * x) : little32(from, 4 * x);
        to[x] = {fields[0].of(pixel), fields[1].of(pixel), fields[2].of(pixel), fields[3].of(pixel)};
    }
}

void plainRows(const BmpHeader& header, ByteSpan data, std::size_t stride, std::span<BmpPixel> pixels) {
    const std::vector<BmpPixel> colors = header.bits <= 8 ? colorsOf(header) : std::vector<BmpPixel>();
    const std::array<Field, 4> fields{Field(header.masks[0], 0), Field(header.masks[1], 0),
                                      Field(header.masks[2], 0), Field(header.masks[3], 255)};
    for (std::size_t y = 0; y < header.height; ++y) {
        const std::size_t row = header.topDown ? y : header.height - 1 - y;
        const std::span<BmpPixel> to = pixels.subspan(row * header.width, header.width);
        const ByteSpan from = data.subspan(y * stride);
        if (header.bits <= 8)
            indexedRow(from, header.bits, colors, to);
        else if (header.bits == 24)
            directRow(from, to);
        else
            fieldRow(from, header.bits, fields, to);
    }
}

}  // namespace

std::optional<std::span<const std::byte>> embeddedPicture(ByteSpan file) {
    const auto header = readBmpHeader(file, {});
    if (!header) return std::nullopt;
    if (header->compression != BmpCompression::jpeg && header->compression != BmpCompression::png)
        return std::nullopt;
    return file.subspan(header->dataOffset);
}

Result<Image> decodeBmp(ByteSpan file, const FileLabel& label, const Limits& limits) {
    auto read = readBmpHeader(file, label);
    if (!read) return std::move(read.diagnostics);
    const BmpHeader& header = *read;
    if (header.compression == BmpCompression::jpeg || header.compression == BmpCompression::png)
        return damaged(label, "the BMP file wraps another picture, which cannot be read here");
    if (auto tooLarge = checkSize(header.width, header.height, 4, limits, label)) return *std::move(tooLarge);

    const bool packed =
        header.compression == BmpCompression::rle4 || header.compression == BmpCompression::rle8;
    if (packed)
        if (auto tooShort = checkInflation(header.width, header.height, file.size(), label))
            return *std::move(tooShort);
    const ByteSpan data = file.subspan(header.dataOffset);
    const std::uint64_t rowBits = std::uint64_t{header.width} * header.bits;
    const std::uint64_t stride = (rowBits + 31) / 32 * 4;
    // Some writers omit the padding of the last row.
    if (!packed && data.size() < stride * (header.height - 1) + (rowBits + 7) / 8)
        return endsEarly(label, data.size() / stride, header.height);

    const std::size_t count = std::size_t{header.width} * header.height;
    Image image = blankImage(header.width, header.height, Component::u8);
    const std::span<BmpPixel> pixels(reinterpret_cast<BmpPixel*>(image.data.data()), count);
    if (packed) {
        const std::uint64_t wholeRows = decodeRunLengths(data, header, colorsOf(header), pixels);
        if (wholeRows < header.height) return endsEarly(label, wholeRows, header.height);
    } else {
        plainRows(header, data, stride, pixels);
    }
    Diagnostics remarks = findStrays(header, label, pixels);
    return {std::move(image), std::move(remarks)};
}

}  // namespace glibra::image
