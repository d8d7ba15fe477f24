#include "image/gif/gif_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <vector>

#include "image/bytes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

constexpr std::size_t kGifHeader = 13;

struct GifColors {
    std::size_t offset = 0, count = 0;
};

/// The first picture of the file.
struct GifFrame {
    std::uint64_t screenWidth = 0, screenHeight = 0;
    std::uint32_t left = 0, top = 0, width = 0, height = 0;
    bool interlaced = false;
    GifColors colors;
    std::optional<std::uint32_t> transparent;
    std::vector<std::byte> codes;  ///< the packed pixels, without the lengths of their blocks
    std::uint32_t codeBits = 0;    ///< least size of a code
};

/// The colour table that the low bits of `flags` describe, at `at`, which moves behind it.
GifColors colorsFrom(std::uint32_t flags, std::size_t& at) {
    if ((flags & 0x80U) == 0) return {};
    const GifColors colors{at, std::size_t{2} << (flags & 7U)};
    at += 3 * colors.count;
    return colors;
}

/// Moves behind the blocks at `at`, which end with an empty one. If `to` is given, it gets their content; the
/// last one may be cut short. False at the end of the file.
bool readBlocks(ByteSpan file, std::size_t& at, std::vector<std::byte>* to) {
    while (at < file.size()) {
        const std::size_t length = octetAt(file, at++);
        if (length == 0) return true;
        const std::size_t have = std::min(length, file.size() - at);
        if (to != nullptr) {
            const auto block = file.subspan(at, have);
            to->insert(to->end(), block.begin(), block.end());
        }
        at += have;
    }
    return false;
}

/// Reads the descriptor of a picture at `at`, and its codes.
Result<GifFrame> readFrame(ByteSpan file, std::size_t at, GifFrame frame, const FileLabel& label) {
    constexpr std::size_t kDescriptor = 9;
    constexpr std::uint32_t kMostBits = 8;
    if (file.size() - at < kDescriptor + 1) return damaged(label, "the file ends before its pixels");
    frame.left = little16(file, at);
    frame.top = little16(file, at + 2);
    frame.width = little16(file, at + 4);
    frame.height = little16(file, at + 6);
    const std::uint32_t flags = octetAt(file, at + 8);
    at += kDescriptor;
    frame.interlaced = (flags & 0x40U) != 0;
    if (const GifColors own = colorsFrom(flags, at); own.count > 0) frame.colors = own;
    if (frame.width == 0 || frame.height == 0)
        return damaged(label, "the picture has no pixels by its GIF header");
    if (frame.colors.count == 0) return damaged(label, "it has no colour table");
    if (frame.colors.offset + 3 * frame.colors.count > file.size() || at >= file.size())
        return damaged(label, "the file ends within its colour table");
    frame.codeBits = octetAt(file, at++);
    if (frame.codeBits < 1 || frame.codeBits > kMostBits)
        return damaged(label, fmt::format("its codes begin with {} bits, expected 1 to 8", frame.codeBits));
    readBlocks(file, at, &frame.codes);
    frame.screenWidth = std::max<std::uint64_t>(frame.screenWidth, frame.left + frame.width);
    frame.screenHeight = std::max<std::uint64_t>(frame.screenHeight, frame.top + frame.height);
    return frame;
}

Result<GifFrame> findFrame(ByteSpan file, const FileLabel& label) {
    if (file.size() < kGifHeader) return damaged(label, "the file ends within the GIF header");
    GifFrame frame;
    frame.screenWidth = little16(file, 6);
    frame.screenHeight = little16(file, 8);
    std::size_t at = kGifHeader;
    frame.colors = colorsFrom(octetAt(file, 10), at);
    while (at < file.size()) {
        constexpr std::uint8_t kExtension = 0x21, kGraphicControl = 0xf9, kPicture = 0x2c, kEnd = 0x3b;
        const std::uint8_t kind = octetAt(file, at++);
        if (kind == kPicture) return readFrame(file, at, std::move(frame), label);
        if (kind == kEnd) break;
        if (kind != kExtension) return damaged(label, fmt::format("unknown block {}", kind));
        if (at + 6 <= file.size() && octetAt(file, at) == kGraphicControl && octetAt(file, at + 1) == 4 &&
            (octetAt(file, at + 2) & 1U) != 0)
            frame.transparent = octetAt(file, at + 5);
        if (!readBlocks(file, ++at, nullptr)) break;
    }
    return damaged(label, "the file ends before its pixels");
}

/// Unpacks the codes (T. Welch, "A Technique for High-Performance Data Compression", 1984) into `to`. Returns
/// how many pixels there are.
std::size_t unpackCodes(const GifFrame& frame, std::vector<std::uint8_t>& to, std::size_t wanted) {
    constexpr std::size_t kMostCodes = 4096;
    struct Entry {
        std::uint16_t before;
        std::uint8_t last, first;
    };
    std::array<Entry, kMostCodes> entries{};
    std::array<std::uint8_t, kMostCodes> text{};
    const std::uint32_t clear = 1U << frame.codeBits, end = clear + 1;
    for (std::uint32_t i = 0; i < clear; ++i)
        entries.at(i) = {0, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i)};
    std::uint32_t next = clear + 2, bits = frame.codeBits + 1, held = 0, heldBits = 0;
    constexpr std::uint32_t kNone = kMostCodes;
    std::uint32_t before = kNone;
    for (const std::byte byte : frame.codes) {
        held |= std::to_integer<std::uint32_t>(byte) << heldBits;
        heldBits += 8;
        while (heldBits >= bits) {
            const std::uint32_t code = held & ((1U << bits) - 1);
            held >>= bits;
            heldBits -= bits;
            if (code == end) return to.size();
            if (code == clear) {
                next = clear + 2;
                bits = frame.codeBits + 1;
                before = kNone;
                continue;
            }
            // The entry that is just being made is its predecessor and that one's first pixel.
            const bool isNew = before != kNone && code == next && next < kMostCodes;
            if (!isNew && code >= (before != kNone ? next : clear)) return to.size();
            const std::uint8_t first = entries.at(isNew ? before : code).first;
            if (before != kNone && next < kMostCodes) {
                entries.at(next) = {static_cast<std::uint16_t>(before), first, entries.at(before).first};
                if (++next == 1U << bits && bits < 12) ++bits;
            }
            std::size_t length = 0;
            std::uint32_t at = code;
            for (; at >= clear; at = entries.at(at).before) text.at(length++) = entries.at(at).last;
            text.at(length++) = static_cast<std::uint8_t>(at);
            while (length > 0 && to.size() < wanted) to.push_back(text.at(--length));
            if (to.size() == wanted) return wanted;
            before = code;
        }
    }
    return to.size();
}

/// The row of the picture for each row of an interlaced file.
std::vector<std::uint32_t> interlacedRows(std::uint32_t height) {
    struct GifPass {
        std::uint32_t first, step;
    };
    std::vector<std::uint32_t> rows;
    for (const auto& [first, step] : {GifPass{0, 8}, GifPass{4, 8}, GifPass{2, 4}, GifPass{1, 2}})
        for (std::uint32_t y = first; y < height; y += step) rows.push_back(y);
    return rows;
}

}  // namespace

Result<Image> decodeGif(ByteSpan file, const FileLabel& label, const Limits& limits) {
    const auto found = findFrame(file, label);
    if (!found) return found.diagnostics;
    const GifFrame& frame = *found;
    if (auto refused = checkPacked(frame.screenWidth, frame.screenHeight, 4, file.size(), limits, label))
        return *std::move(refused);

    const std::size_t count = std::size_t{frame.width} * frame.height;
    std::vector<std::uint8_t> indices;
    indices.reserve(count);
    if (const std::size_t have = unpackCodes(frame, indices, count); have < count)
        return endsEarly(label, have / frame.width, frame.height);

    Image image = blankImage(frame.screenWidth, frame.screenHeight, Component::u8);
    const std::vector<std::uint32_t> rows =
        frame.interlaced ? interlacedRows(frame.height) : std::vector<std::uint32_t>();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = indices[i];
        if (index == frame.transparent) continue;
        if (index >= frame.colors.count)
            return damaged(label, fmt::format("a pixel has the colour {}, but the colour table has 0 to {}",
                                              index, frame.colors.count - 1));
        const std::size_t row = i / frame.width, y = frame.top + (rows.empty() ? row : rows[row]);
        std::byte* const to = image.data.data() + 4 * (y * frame.screenWidth + frame.left + i % frame.width);
        std::memcpy(to, file.data() + frame.colors.offset + std::size_t{3} * index, 3);
        to[3] = std::byte{255};
    }
    return image;
}

}  // namespace glibra::image
