#include "image/bmp/bmp_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "image/bit_field.h"
#include "image/bmp/bmp_header.h"
#include "image/bmp/bmp_run_lengths.h"
#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

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
        const std::uint64_t wholeRows = decodeRunLengths(
            data, {header.width, header.height, header.topDown, header.bits}, colorsOf(header), pixels);
        if (wholeRows < header.height) return endsEarly(label, wholeRows, header.height);
    } else {
        plainRows(header, data, stride, pixels);
    }
    Diagnostics remarks = findStrays(header, label, pixels);
    return {std::move(image), std::move(remarks)};
}

}  // namespace glibra::image
