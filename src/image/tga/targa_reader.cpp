#include "image/tga/targa_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "image/alpha.h"
#include "image/bit_field.h"
#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

using TargaPixel = std::array<std::uint8_t, 4>;  // red, green, blue, alpha

constexpr std::size_t kTargaHeader = 18;

enum class TargaKind { mapped = 1, color = 2, grey = 3 };

/// What the extension area says of alpha (field 24).
enum class TargaAlpha { none = 0, ignored = 1, kept = 2, useful = 3, premultiplied = 4 };

struct TargaHeader {
    TargaKind kind = TargaKind::color;
    bool packed = false;
    std::uint32_t width = 0, height = 0, bits = 0;
    bool rightToLeft = false, topDown = false;
    bool hasAttributes = false;  ///< 16-bit pixels have alpha
    std::uint32_t firstEntry = 0, entries = 0, entryBits = 0;
    std::size_t mapOffset = 0, dataOffset = 0;
    TargaAlpha alpha = TargaAlpha::useful;
};

std::uint32_t bytesFor(std::uint32_t bits) {
    return (bits + 7) / 8;
}

bool isColorDepth(std::uint32_t bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

TargaAlpha alphaOfExtension(ByteSpan file) {
    constexpr std::size_t kFooter = 26, kExtension = 495, kAttributes = 494;
    constexpr std::string_view kSignature = "TRUEVISION-XFILE";
    if (file.size() < kTargaHeader + kFooter) return TargaAlpha::useful;
    const std::size_t footer = file.size() - kFooter;
    for (std::size_t i = 0; i < kSignature.size(); ++i)
        if (octetAt(file, footer + 8 + i) != static_cast<std::uint8_t>(kSignature[i]))
            return TargaAlpha::useful;
    const std::size_t at = little32(file, footer);
    if (at < kTargaHeader || at + kExtension > footer || little16(file, at) != kExtension)
        return TargaAlpha::useful;
    const std::uint8_t type = octetAt(file, at + kAttributes);
    return type <= 4 ? static_cast<TargaAlpha>(type) : TargaAlpha::useful;
}

Result<TargaHeader> readTargaHeader(ByteSpan file, const FileLabel& label) {
    if (file.size() < kTargaHeader) return damaged(label, "the file ends within the TGA header");
    const std::uint32_t mapType = octetAt(file, 1), type = octetAt(file, 2), flags = octetAt(file, 17);
    TargaHeader header;
    header.packed = (type & 8U) != 0;
    if ((type & ~8U) < 1 || (type & ~8U) > 3) return damaged(label, fmt::format("unknown TGA type {}", type));
    header.kind = static_cast<TargaKind>(type & ~8U);
    header.width = little16(file, 12);
    header.height = little16(file, 14);
    header.bits = octetAt(file, 16);
    header.rightToLeft = (flags & 0x10U) != 0;
    header.topDown = (flags & 0x20U) != 0;
    header.hasAttributes = (flags & 0xfU) != 0;
    if (header.width == 0 || header.height == 0)
        return damaged(label, "the picture has no pixels by its TGA header");
    const bool known =
        header.kind == TargaKind::color ? isColorDepth(header.bits) : header.bits == 8 || header.bits == 16;
    if (!known)
        return damaged(label, fmt::format("unknown TGA type {} with {} bits per pixel", type, header.bits));

    if (mapType != 0) {
        header.firstEntry = little16(file, 3);
        header.entries = little16(file, 5);
        header.entryBits = octetAt(file, 7);
    }
    if (header.kind == TargaKind::mapped && (header.entries == 0 || !isColorDepth(header.entryBits)))
        return damaged(
            label, fmt::format("its colour map has {} entries of {} bits", header.entries, header.entryBits));
    header.mapOffset = kTargaHeader + octetAt(file, 0);
    header.dataOffset = header.mapOffset + std::size_t{header.entries} * bytesFor(header.entryBits);
    if (header.dataOffset >= file.size()) return damaged(label, "the file ends before its pixels");
    header.alpha = alphaOfExtension(file);
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

/// Reads single pixels.
class TargaPixels {
  public:
    TargaPixels(ByteSpan file, const TargaHeader& header) : file_(file), header_(header) {
        if (header.kind != TargaKind::mapped) return;
        for (std::uint32_t i = 0; i < header.entries; ++i)
            map_.push_back(colorAt(file, header.mapOffset + std::size_t{i} * bytesFor(header.entryBits),
                                   header.entryBits, false));
    }

    /// The pixel whose bytes, which exist, begin there. A pixel without a colour is remembered.
    TargaPixel at(std::size_t offset) {
        const bool wide = header_.bits > 8;
        if (header_.kind == TargaKind::color)
            return colorAt(file_, offset, header_.bits, header_.hasAttributes);
        if (header_.kind == TargaKind::grey) {
            const std::uint8_t grey = octetAt(file_, offset);
            return {grey, grey, grey, wide ? octetAt(file_, offset + 1) : std::uint8_t{255}};
        }
        const std::uint32_t index = wide ? little16(file_, offset) : octetAt(file_, offset);
        if (index >= header_.firstEntry && index - header_.firstEntry < map_.size())
            return map_[index - header_.firstEntry];
        if (!strayIndex_) strayIndex_ = index;
        return {};
    }

    [[nodiscard]] std::optional<std::uint32_t> strayIndex() const { return strayIndex_; }

  private:
    ByteSpan file_;
    const TargaHeader& header_;
    std::vector<TargaPixel> map_;
    std::optional<std::uint32_t> strayIndex_;
};

/// Decodes the pixels in the order of the file. Returns how many there are.
std::uint64_t decodePixels(ByteSpan file, const TargaHeader& header, TargaPixels& pixels,
                           std::span<TargaPixel> to) {
    const std::size_t bytes = bytesFor(header.bits);
    std::size_t at = header.dataOffset, done = 0;
    if (!header.packed) {
        const std::size_t count = std::min(to.size(), (file.size() - at) / bytes);
        for (; done < count; ++done, at += bytes) to[done] = pixels.at(at);
        return done;
    }
    while (done < to.size() && at + 1 + bytes <= file.size()) {
        const std::size_t packet = octetAt(file, at++);
        const std::size_t count = std::min<std::size_t>((packet & 0x7fU) + 1, to.size() - done);
        if ((packet & 0x80U) != 0) {
            std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(done), count, pixels.at(at));
            done += count;
            at += bytes;
        } else {
            for (std::size_t i = 0; i < count && at + bytes <= file.size(); ++i, at += bytes)
                to[done++] = pixels.at(at);
        }
    }
    return done;
}

void orient(const TargaHeader& header, std::span<TargaPixel> pixels) {
    const std::size_t width = header.width;
    if (header.rightToLeft)
        for (std::size_t row = 0; row < header.height; ++row) {
            const auto begin = pixels.begin() + static_cast<std::ptrdiff_t>(row * width);
            std::reverse(begin, begin + static_cast<std::ptrdiff_t>(width));
        }
    if (!header.topDown)
        for (std::size_t row = 0; row < header.height / 2; ++row) {
            const auto top = pixels.subspan(row * width, width);
            const auto bottom = pixels.subspan((header.height - 1 - row) * width, width);
            std::swap_ranges(top.begin(), top.end(), bottom.begin());
        }
}

}  // namespace

Result<Image> decodeTarga(ByteSpan file, const FileLabel& label, const Limits& limits) {
    auto read = readTargaHeader(file, label);
    if (!read) return std::move(read.diagnostics);
    const TargaHeader& header = *read;
    if (auto refused = checkPacked(header.width, header.height, 4, file.size(), limits, label))
        return *std::move(refused);

    Image image = blankImage(header.width, header.height, Component::u8);
    const std::size_t count = std::size_t{header.width} * header.height;
    const std::span<TargaPixel> to(reinterpret_cast<TargaPixel*>(image.data.data()), count);
    TargaPixels pixels(file, header);
    const std::uint64_t done = decodePixels(file, header, pixels, to);
    if (done < count) return endsEarly(label, done / header.width, header.height);
    if (const auto stray = pixels.strayIndex())
        return damaged(label, fmt::format("a pixel has the colour {}, but the colour map has {} to {}",
                                          *stray, header.firstEntry, header.firstEntry + header.entries - 1));
    orient(header, to);
    if (header.alpha == TargaAlpha::none || header.alpha == TargaAlpha::ignored)
        for (TargaPixel& each : to) each[3] = 255;
    if (header.alpha == TargaAlpha::premultiplied) unassociateAlpha(image);
    return image;
}

}  // namespace glibra::image
