#include "image/png/png_reader.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <spng.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include "image/bytes.h"

namespace glibra::image {
namespace {

/// Adds the content of a chunk; false if it must not occur here.
bool add(std::string_view type, std::span<const std::byte> content, PngChunks& chunks, bool dataEnded) {
    if (type == "IHDR") {
        if (content.size() != 13 || chunks.bitDepth != 0) return false;
        chunks.width = big32(content, 0);
        chunks.height = big32(content, 4);
        chunks.bitDepth = std::to_integer<int>(content[8]);
        chunks.colorType = std::to_integer<int>(content[9]);
        chunks.interlaced = content[12] != std::byte{0};
        return content[10] == std::byte{0} && content[11] == std::byte{0};
    }
    if (chunks.bitDepth == 0) return false;
    if (type == "tRNS") chunks.transparentColor = true;
    if (type == "IDAT") {
        if (dataEnded) return false;
        chunks.data.push_back(content);
        return true;
    }
    if (type == "IEND") return true;
    chunks.others.push_back({type, content, dataEnded});
    return type == "PLTE" || type[0] >= 'a';  // lower case marks ancillary chunks
}

}  // namespace

std::optional<PngChunks> pngChunks(std::span<const std::byte> file) {
    constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
    const auto signature = std::as_bytes(std::span(kSignature));
    if (file.size() < 8 || !std::equal(signature.begin(), signature.end(), file.begin())) return {};
    PngChunks chunks;
    bool dataEnded = false;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = big32(file, at);
        if (length > file.size() - at - 12) return {};
        const std::string_view type(reinterpret_cast<const char*>(file.data()) + at + 4, 4);
        if (libdeflate_crc32(0, file.data() + at + 4, length + 4) != big32(file, at + 8 + length)) return {};
        if (type != "IDAT" && !chunks.data.empty()) dataEnded = true;
        if (!add(type, file.subspan(at + 8, length), chunks, dataEnded)) return {};
        at += length + 12;
        if (type == "IEND")
            return at == file.size() && !chunks.data.empty() ? std::optional(chunks) : std::nullopt;
    }
    return {};
}

namespace {

struct FreeDecompressor {
    void operator()(libdeflate_decompressor* each) const { libdeflate_free_decompressor(each); }
};

/// The predictor of PNG's filter type 4 (PNG specification, 9.4).
std::uint8_t paeth(int left, int above, int corner) {
    const int toLeft = std::abs(above - corner), toAbove = std::abs(left - corner);
    const int toCorner = std::abs(left + above - 2 * corner);
    if (toLeft <= toAbove && toLeft <= toCorner) return static_cast<std::uint8_t>(left);
    return static_cast<std::uint8_t>(toAbove <= toCorner ? above : corner);
}

/// Undoes a row's filter in place; `above` is the row before, or zeros. False for an unknown filter.
template <std::size_t Pixel>
bool unfilter(std::uint8_t type, std::uint8_t* row, const std::uint8_t* above, std::size_t count) {
    const auto add = [](std::uint8_t a, int b) { return static_cast<std::uint8_t>(a + b); };
    switch (type) {
        case 0:
            return true;
        case 1:
            for (std::size_t i = Pixel; i < count; ++i) row[i] = add(row[i], row[i - Pixel]);
            return true;
        case 2:
            for (std::size_t i = 0; i < count; ++i) row[i] = add(row[i], above[i]);
            return true;
        case 3:
            for (std::size_t i = 0; i < Pixel; ++i) row[i] = add(row[i], above[i] / 2);
            for (std::size_t i = Pixel; i < count; ++i) row[i] = add(row[i], (row[i - Pixel] + above[i]) / 2);
            return true;
        case 4:
            for (std::size_t i = 0; i < Pixel; ++i) row[i] = add(row[i], above[i]);
            for (std::size_t i = Pixel; i < count; ++i)
                row[i] = add(row[i], paeth(row[i - Pixel], above[i], above[i - Pixel]));
            return true;
        default:
            return false;
    }
}

/// RGB to RGBA, a word at a time.
void addAlpha(const std::uint8_t* rgb, std::size_t width, std::byte* to) {
    const std::uint32_t opaque = std::endian::native == std::endian::little ? 0xff000000U : 0x000000ffU;
    for (std::size_t x = 0; x + 1 < width; ++x, rgb += 3, to += 4) {
        std::uint32_t word = 0;
        std::memcpy(&word, rgb, 4);  // the fourth byte is the next pixel's
        word |= opaque;
        std::memcpy(to, &word, 4);
    }
    std::memcpy(to, rgb, 3);
    to[3] = std::byte{255};
}

/// Unpacks the pixels to `rows`, each row after its filter's type; false if they are not exactly as long.
bool inflate(const PngChunks& chunks, std::span<std::byte> rows) {
    std::vector<std::byte> joined;
    std::span<const std::byte> packed = chunks.data.front();
    if (chunks.data.size() > 1) {
        for (const auto& each : chunks.data) joined.insert(joined.end(), each.begin(), each.end());
        packed = joined;
    }
    const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
        libdeflate_alloc_decompressor());
    return decompressor &&
           libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), rows.data(),
                                      rows.size(), nullptr) == LIBDEFLATE_SUCCESS;
}

/// The rows are at the end of the memory that the pixels go to; each is out of the way before its place is
/// written, since pixels are never shorter than their packed form.
template <std::size_t Pixel>
bool unpackRows(const std::byte* rows, std::size_t width, std::size_t height, std::byte* to) {
    const std::size_t count = width * Pixel;
    std::vector<std::uint8_t> row(count), above(count);
    for (std::size_t y = 0; y < height; ++y, rows += count + 1, to += 4 * width) {
        std::memcpy(row.data(), rows + 1, count);
        if (!unfilter<Pixel>(std::to_integer<std::uint8_t>(*rows), row.data(), above.data(), count))
            return false;
        if constexpr (Pixel == 4)
            std::memcpy(to, row.data(), count);
        else
            addAlpha(row.data(), width, to);
        std::swap(row, above);
    }
    return true;
}

}  // namespace

std::optional<Image> decodeUsualPng(std::span<const std::byte> file) {
    constexpr int kRgb = 2, kRgba = 6;
    const auto chunks = pngChunks(file);
    if (!chunks || chunks->bitDepth != 8 || chunks->interlaced || chunks->transparentColor) return {};
    if (chunks->colorType != kRgb && chunks->colorType != kRgba) return {};
    const std::size_t width = chunks->width, height = chunks->height;
    if (width == 0 || height == 0) return {};
    const std::size_t pixel = chunks->colorType == kRgb ? 3 : 4;
    Image image{static_cast<int>(width), static_cast<int>(height), 4, Component::u8, {}};
    const std::size_t size = image.rowBytes() * height, packedSize = (width * pixel + 1) * height;
    image.data.resize(std::max(size, packedSize));
    const auto rows = std::span(image.data).last(packedSize);
    if (!inflate(*chunks, rows)) return {};
    const bool done = pixel == 3 ? unpackRows<3>(rows.data(), width, height, image.data.data())
                                 : unpackRows<4>(rows.data(), width, height, image.data.data());
    image.data.resize(size);
    return done ? std::optional(std::move(image)) : std::nullopt;
}

namespace {

struct FreeContext {
    void operator()(spng_ctx* each) const { spng_ctx_free(each); }
};
using Context = std::unique_ptr<spng_ctx, FreeContext>;

/// Deflate packs at most 1032 bytes into one (zlib's technical notes). So a short file that claims a huge
/// picture is rejected before memory is reserved.
constexpr std::uint64_t kLargestRatio = 1032;

Diagnostic broken(const FileLabel& label, int code) {
    return damaged(label, fmt::format("damaged PNG file ({})", spng_strerror(code)));
}

/// A lower bound of the bytes of the unfiltered picture (interlacing adds a little).
std::uint64_t packedBytes(const spng_ihdr& header) {
    constexpr std::uint64_t kChannels[] = {1, 0, 3, 1, 2, 0, 4};
    const std::uint64_t bits =
        std::uint64_t{header.width} * header.bit_depth * kChannels[header.color_type % 7];
    return (bits + 7) / 8 * header.height;
}

}  // namespace

Result<Image> decodePng(std::span<const std::byte> file, const FileLabel& label, const Limits& limits) {
    const Context context(spng_ctx_new(0));
    if (!context) return damaged(label, "there is not enough memory to read it");
    // Compressed text and profiles may grow to this size; no chunk of a valid file is longer than the file.
    constexpr std::size_t kSpareBytes = std::size_t{16} << 20;
    spng_set_chunk_limits(context.get(), std::min<std::size_t>(file.size() + kSpareBytes, 0x7fffffff),
                          file.size() + 4 * kSpareBytes);
    spng_set_png_buffer(context.get(), file.data(), file.size());

    spng_ihdr header{};
    if (const int failed = spng_get_ihdr(context.get(), &header); failed != 0) return broken(label, failed);
    const bool wide = header.bit_depth == 16;
    if (auto tooLarge = checkSize(header.width, header.height, wide ? 8 : 4, limits, label))
        return *std::move(tooLarge);
    if (packedBytes(header) / kLargestRatio > file.size())
        return damaged(label, fmt::format("{} bytes cannot hold {} x {} pixels", file.size(), header.width,
                                          header.height));
    if (auto usual = decodeUsualPng(file)) return *std::move(usual);

    const int format = wide ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    std::size_t size = 0;
    if (const int failed = spng_decoded_image_size(context.get(), format, &size); failed != 0)
        return broken(label, failed);
    Image image{static_cast<int>(header.width),
                static_cast<int>(header.height),
                4,
                wide ? Component::u16 : Component::u8,
                {}};
    image.data.resize(size);
    const int failed = spng_decode_image(context.get(), image.data.data(), size, format, SPNG_DECODE_TRNS);
    if (failed == SPNG_IO_EOF || failed == SPNG_EIDAT_TOO_SHORT)
        return damaged(label,
                       fmt::format("the file ends before the pixels of its {} rows do", header.height));
    if (failed != 0) return broken(label, failed);
    return image;
}

namespace {

using Content = std::span<const std::byte>;

/// True if the numbers of 32 bits are these, up to rounding.
template <std::size_t Count>
bool holds(Content content, const std::array<std::uint32_t, Count>& numbers) {
    constexpr std::int64_t kRounding = 20;  // of 100,000
    if (content.size() != 4 * Count) return false;
    for (std::size_t i = 0; i < Count; ++i)
        if (std::abs(std::int64_t{big32(content, 4 * i)} - std::int64_t{numbers[i]}) > kRounding)
            return false;
    return true;
}

/// Gamma and primaries of sRGB (PNG specification, third edition, 11.3.2.5).
bool isGammaOfSrgb(Content content) {
    return holds<1>(content, {45455});
}
bool arePrimariesOfSrgb(Content content) {
    return holds<8>(content, {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
}
bool areSquare(Content content) {
    return content.size() == 9 && big32(content, 0) == big32(content, 4);
}
bool always(Content) {
    return true;
}
bool never(Content) {
    return false;
}

/// Chunks that change nothing, if their content is as it should be.
struct HarmlessRow {
    std::string_view type;
    bool (*isHarmless)(Content);
    bool isOnce = false;  ///< there is one of them, before the pixels
};
constexpr std::array kHarmless{
    HarmlessRow{"PLTE", always, true},  HarmlessRow{"tRNS", always, true},
    HarmlessRow{"tEXt", always},        HarmlessRow{"zTXt", always},
    HarmlessRow{"iTXt", always},        HarmlessRow{"tIME", always},
    HarmlessRow{"sBIT", always},        HarmlessRow{"sRGB", always},
    HarmlessRow{"gAMA", isGammaOfSrgb}, HarmlessRow{"cHRM", arePrimariesOfSrgb},
    HarmlessRow{"pHYs", areSquare},     HarmlessRow{"hIST", always},
    HarmlessRow{"bKGD", never, true},  // but for opaque pixels
};

/// What the others do.
using Meaning = std::pair<std::string_view, const char*>;
constexpr std::array kMeanings{
    Meaning{"acTL", "it is an animation"},
    Meaning{"fcTL", "it has frames of an animation"},
    Meaning{"fdAT", "it has frames of an animation"},
    Meaning{"iCCP", "it has a colour profile"},
    Meaning{"cICP", "it has another colour space"},
    Meaning{"gAMA", "it has another gamma than sRGB"},
    Meaning{"cHRM", "it has other primaries than sRGB"},
    Meaning{"mDCv", "it is meant for a screen of high dynamic range"},
    Meaning{"cLLi", "it is meant for a screen of high dynamic range"},
    Meaning{"eXIf", "it may say that it is to be turned"},
    Meaning{"bKGD", "it has a background colour"},
    Meaning{"pHYs", "its pixels are not square"},
};

}  // namespace

std::string shownOtherwise(std::span<const std::byte> file) {
    const auto chunks = pngChunks(file);
    if (!chunks)
        return "it is not one whole PNG picture: a checksum is wrong, its chunks are out of order, or "
               "something follows its end";
    std::vector<std::string_view> before;
    constexpr int kHasAlpha = 4;  // of the colour type
    const bool isOpaque = (chunks->colorType & kHasAlpha) == 0 && !chunks->transparentColor;
    for (const PngChunk& each : chunks->others) {
        const auto* const row = std::ranges::find(kHarmless, each.type, &HarmlessRow::type);
        const bool isSeen = each.type != "bKGD" || !isOpaque;
        if (row == kHarmless.end() || (isSeen && !row->isHarmless(each.content))) {
            const auto* const known = std::ranges::find(kMeanings, each.type, &Meaning::first);
            return fmt::format("{} (chunk {})",
                               known == kMeanings.end() ? "it has data of an unknown meaning" : known->second,
                               each.type);
        }
        const bool isRepeated = std::ranges::find(before, each.type) != before.end();
        if (row->isOnce && (isRepeated || each.afterData))
            return fmt::format("it has a chunk {} too many or in the wrong place", each.type);
        before.push_back(each.type);
    }
    return {};
}

}  // namespace glibra::image
