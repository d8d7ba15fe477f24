#include "image/sgi/sgi_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

constexpr std::size_t kSgiHeader = 512;

struct SgiHeader {
    bool packed = false;
    std::size_t sampleBytes = 1;
    std::size_t width = 0, height = 1, channels = 1;
};

Result<SgiHeader> readSgiHeader(ByteSpan file, const FileLabel& label) {
    if (file.size() <= kSgiHeader) return damaged(label, "the file ends within the SGI header");
    SgiHeader header;
    header.packed = octetAt(file, 2) == 1;
    header.sampleBytes = octetAt(file, 3);
    const std::uint32_t dimensions = big16(file, 4), colorMap = big32(file, 104);
    header.width = big16(file, 6);
    if (dimensions >= 2) header.height = big16(file, 8);
    if (dimensions >= 3) header.channels = big16(file, 10);
    if (octetAt(file, 2) > 1 || header.sampleBytes < 1 || header.sampleBytes > 2)
        return damaged(label, "unknown kind of SGI picture");
    if (dimensions < 1 || dimensions > 3 || header.width == 0 || header.height == 0 || header.channels == 0)
        return damaged(label, "the picture has no pixels by its SGI header");
    if (colorMap != 0)
        return damaged(
            label,
            fmt::format("its colour map, kind {}, cannot be read; only plain components can", colorMap));
    return header;
}

template <class Value>
Value sampleAt(ByteSpan file, std::size_t at) {
    if constexpr (sizeof(Value) == 1)
        return octetAt(file, at);
    else
        return static_cast<Value>(big16(file, at));
}

template <class Value>
void putSample(Image& image, std::size_t pixel, std::size_t component, Value value) {
    std::memcpy(image.data.data() + (4 * pixel + component) * sizeof value, &value, sizeof value);
}

/// Unpacks the run lengths of one row of one channel. False if they are too few or reach beyond the file.
template <class Value>
bool unpackRow(ByteSpan packed, Image& image, std::size_t firstPixel, std::size_t component) {
    const auto width = static_cast<std::size_t>(image.width);
    std::size_t at = 0, x = 0;
    while (at + sizeof(Value) <= packed.size()) {
        const Value control = sampleAt<Value>(packed, at);
        at += sizeof(Value);
        const std::size_t count = control & 0x7fU;
        const bool isLiteral = (control & 0x80U) != 0;
        if (count == 0) break;
        if (count > width - x || at + sizeof(Value) * (isLiteral ? count : 1) > packed.size()) return false;
        for (std::size_t i = 0; i < count; ++i)
            putSample(image, firstPixel + x++, component,
                      sampleAt<Value>(packed, at + (isLiteral ? i * sizeof(Value) : 0)));
        at += sizeof(Value) * (isLiteral ? count : 1);
    }
    return x == width;
}

template <class Value>
std::optional<Diagnostic> readSgiRows(ByteSpan file, const SgiHeader& header, const FileLabel& label,
                                      Image& image) {
    const std::size_t channels = std::min<std::size_t>(header.channels, 4);
    const std::size_t rows = header.height * header.channels;
    for (std::size_t channel = 0; channel < channels; ++channel)
        for (std::size_t y = 0; y < header.height; ++y) {
            const std::size_t row = channel * header.height + y;
            const std::size_t first = (header.height - 1 - y) * header.width;
            const std::size_t component = channels == 2 && channel == 1 ? 3 : channel;
            if (header.packed) {
                const std::size_t begin = big32(file, kSgiHeader + 4 * row),
                                  length = big32(file, kSgiHeader + 4 * (rows + row));
                if (begin > file.size() || length > file.size() - begin ||
                    !unpackRow<Value>(file.subspan(begin, length), image, first, component))
                    return damaged(label, fmt::format("row {} of channel {} is damaged", y + 1, channel + 1));
            } else {
                const std::size_t begin = kSgiHeader + row * header.width * sizeof(Value);
                for (std::size_t x = 0; x < header.width; ++x)
                    putSample(image, first + x, component, sampleAt<Value>(file, begin + x * sizeof(Value)));
            }
        }
    const std::size_t pixels = header.width * header.height;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (channels < 3)
            for (const std::size_t c : {1U, 2U})
                putSample(image, i, c, valueAt<Value>(image.data.data(), 4 * i));
        if (channels % 2 != 0) putSample(image, i, 3, std::numeric_limits<Value>::max());
    }
    return std::nullopt;
}

}  // namespace

Result<Image> decodeSgi(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto read = readSgiHeader(file, label);
    if (!read) return read.diagnostics;
    const SgiHeader& header = *read;
    const Component type = header.sampleBytes == 1 ? Component::u8 : Component::u16;
    if (auto refused =
            checkPacked(header.width, header.height, 4 * bytesOf(type), file.size(), limits, label))
        return *std::move(refused);
    const std::uint64_t rows = std::uint64_t{header.height} * header.channels;
    const std::uint64_t rowBytes = header.packed ? 8 : header.width * header.sampleBytes;
    if (const std::uint64_t have = (file.size() - kSgiHeader) / rowBytes; have < rows)
        return endsEarly(label, have % header.height, header.height);

    Image image = blankImage(header.width, header.height, type);
    auto problem = type == Component::u8 ? readSgiRows<std::uint8_t>(file, header, label, image)
                                         : readSgiRows<std::uint16_t>(file, header, label, image);
    if (problem) return *std::move(problem);
    return image;
}

}  // namespace glibra::image
