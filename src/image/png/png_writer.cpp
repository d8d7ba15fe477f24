#include "image/png/png_writer.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "image/bytes.h"
#include "image/convert.h"
#include "image/image.h"
#include "image/png/deflate_end.h"
#include "image/png/png_rows.h"

namespace glibra::image {
namespace {

constexpr std::size_t kStripeBytes = std::size_t{512} << 10;

struct Stripe {
    int firstRow = 0, rows = 0;
};

std::vector<Stripe> stripesOf(const Image& image) {
    const std::size_t size = (1 + image.rowBytes()) * static_cast<std::size_t>(image.height);
    const auto count = static_cast<int>(
        std::clamp<std::size_t>(size / kStripeBytes, 1, static_cast<std::size_t>(image.height)));
    const int rows = (image.height + count - 1) / count;
    std::vector<Stripe> stripes;
    for (int y = 0; y < image.height; y += rows) stripes.push_back({y, std::min(rows, image.height - y)});
    return stripes;
}

struct FreeCompressor {
    void operator()(libdeflate_compressor* each) const { libdeflate_free_compressor(each); }
};

/// The DEFLATE stream of a stripe, and the checksum of the packed bytes.
struct PackedStripe {
    std::vector<std::byte> stream;
    std::uint32_t adler = 1;
};

/// The buffers of one thread, used for one stripe after another.
class StripePacker {
  public:
    StripePacker(const Image& image, int level, std::size_t mostBytes)
        : image_(image), isFrame_(level == 0), compressor_(libdeflate_alloc_compressor(std::max(level, 1))) {
        if (!compressor_) throw std::bad_alloc();
        filtered_ = std::make_unique_for_overwrite<std::uint8_t[]>(mostBytes);
        bound_ = libdeflate_deflate_compress_bound(compressor_.get(), mostBytes);
        packed_ = std::make_unique_for_overwrite<std::byte[]>(bound_);
    }

    PackedStripe pack(Stripe stripe, bool isLast) {
        const std::size_t size = (1 + image_.rowBytes()) * static_cast<std::size_t>(stripe.rows);
        const PngFiltering filtering =
            isFrame_ ? PngFiltering::up : chooseFiltering(image_, stripe.firstRow, stripe.rows);
        filterRows(image_, stripe.firstRow, stripe.rows, filtering, filtered_.get());
        PackedStripe result;
        result.adler = libdeflate_adler32(1, filtered_.get(), size);
        const std::size_t packedSize =
            libdeflate_deflate_compress(compressor_.get(), filtered_.get(), size, packed_.get(), bound_);
        result.stream.assign(packed_.get(), packed_.get() + packedSize);
        if (!isLast) makeContinuable(result.stream);
        return result;
    }

  private:
    const Image& image_;
    bool isFrame_;
    std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor_;
    std::unique_ptr<std::uint8_t[]> filtered_;
    std::unique_ptr<std::byte[]> packed_;
    std::size_t bound_ = 0;
};

/// Packs all stripes, with this thread and others; empty if there is not enough memory.
std::vector<PackedStripe> packStripes(const Image& image, const std::vector<Stripe>& stripes, int level,
                                      int threads) {
    std::vector<PackedStripe> packed(stripes.size());
    const auto mostRows = static_cast<std::size_t>(stripes.front().rows);
    try {
        base::forEachIndex(
            stripes.size(), threads,
            [&] { return StripePacker(image, level, (1 + image.rowBytes()) * mostRows); },
            [&](std::size_t i, StripePacker& packer) {
                packed[i] = packer.pack(stripes[i], i + 1 == stripes.size());
            });
    } catch (const std::bad_alloc&) {
        return {};
    }
    return packed;
}

/// The Adler-32 checksum of two consecutive texts from the checksums of both (RFC 1950, section 9: a is 1
/// plus the sum of the bytes, b is the sum of all intermediate values of a).
std::uint32_t joinAdler(std::uint32_t first, std::uint32_t second, std::size_t secondSize) {
    constexpr std::uint64_t kPrime = 65521;
    const std::uint64_t firstA = first & 0xffffU, firstB = first >> 16U;
    const std::uint64_t secondA = second & 0xffffU, secondB = second >> 16U;
    const std::uint64_t a = (firstA + secondA + kPrime - 1) % kPrime;
    const std::uint64_t b =
        (firstB + secondB + secondSize % kPrime * ((firstA + kPrime - 1) % kPrime)) % kPrime;
    return static_cast<std::uint32_t>(b << 16U | a);
}

/// The zlib stream for the IDAT chunks, of u8 or u16 components. The rows are divided into stripes by their
/// number of bytes alone, packed by up to `threads` threads (0: one per processor) and joined, so the number
/// of threads does not change the bytes. `level` is PngOptions::level. Empty if there is not enough memory.
std::vector<std::byte> packPngData(const Image& image, int level, unsigned threads) {
    const std::size_t rowSize = 1 + image.rowBytes();
    const std::vector<Stripe> stripes = stripesOf(image);
    const auto packed = packStripes(image, stripes, level, static_cast<int>(threads));
    if (packed.empty()) return {};

    std::vector<std::byte> stream{std::byte{0x78}, std::byte{0x5e}};  // window of 32 KiB, packed fast
    std::size_t size = stream.size() + 4;
    for (const PackedStripe& each : packed) size += each.stream.size();
    stream.reserve(size);
    std::uint32_t adler = 1;
    for (std::size_t i = 0; i < packed.size(); ++i) {
        stream.insert(stream.end(), packed[i].stream.begin(), packed[i].stream.end());
        adler = joinAdler(adler, packed[i].adler, rowSize * static_cast<std::size_t>(stripes[i].rows));
    }
    putBig32(stream, adler);
    return stream;
}

// PNG allows 2^31 - 1; this is a round number below it.
constexpr std::size_t kLargestChunk = std::size_t{1} << 30;

std::span<const std::byte> textBytes(std::string_view text) {
    return std::as_bytes(std::span(text));
}

bool isPrintable(char each) {
    return each >= ' ' && each <= '~';
}

void putText(std::vector<std::byte>& png, const std::string& keyword, const std::string& text) {
    if (keyword.empty() || keyword.size() > 79 || !std::all_of(keyword.begin(), keyword.end(), isPrintable))
        return;
    const bool plain =
        std::all_of(text.begin(), text.end(), [](char each) { return isPrintable(each) || each == '\n'; });
    // iTXt: not compressed, no language, no translated keyword.
    const std::string content = keyword + (plain ? std::string(1, '\0') : std::string(5, '\0')) + text;
    if (content.size() > kLargestChunk) return;
    putPngChunk(png, plain ? "tEXt" : "iTXt", textBytes(content));
}

}  // namespace

void putPngChunk(std::vector<std::byte>& png, std::string_view type, std::span<const std::byte> content) {
    putBig32(png, static_cast<std::uint32_t>(content.size()));
    const std::size_t begin = png.size();
    const auto name = textBytes(type);
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), content.begin(), content.end());
    putBig32(png, libdeflate_crc32(0, png.data() + begin, png.size() - begin));
}

void putPngHeader(std::vector<std::byte>& png, const Image& image) {
    const auto signature = textBytes("\x89PNG\r\n\x1a\n");
    png.insert(png.end(), signature.begin(), signature.end());
    constexpr std::array<std::uint8_t, 5> kColorTypes{0, 0, 4, 2, 6};  // by component count
    std::vector<std::byte> header;
    putBig32(header, static_cast<std::uint32_t>(image.width));
    putBig32(header, static_cast<std::uint32_t>(image.height));
    header.push_back(static_cast<std::byte>(image.type == Component::u8 ? 8 : 16));
    header.push_back(static_cast<std::byte>(kColorTypes.at(static_cast<std::size_t>(image.components))));
    header.insert(header.end(), 3, std::byte{0});  // deflate, adaptive filters, not interlaced
    putPngChunk(png, "IHDR", header);
}

std::vector<std::byte> encodePng(const Image& image, const PngOptions& options) {
    if (!isConsistent(image) || image.type == Component::f32) return {};
    const std::vector<std::byte> data = packPngData(image, std::clamp(options.level, 0, 12), options.threads);
    if (data.empty()) return {};

    std::vector<std::byte> png;
    png.reserve(data.size() + 1024);
    putPngHeader(png, image);
    for (const auto& [keyword, text] : options.text) putText(png, keyword, text);
    for (std::size_t at = 0; at < data.size(); at += kLargestChunk)
        putPngChunk(png, "IDAT", std::span(data).subspan(at, std::min(kLargestChunk, data.size() - at)));
    putPngChunk(png, "IEND", {});
    return png;
}

namespace {

constexpr int kPixel = 3;     // bytes
constexpr int kSmallest = 9;  // level: films are written once and loaded often

void putBig16(std::vector<std::byte>& to, std::uint32_t value) {
    to.push_back(static_cast<std::byte>(value >> 8U & 0xffU));
    to.push_back(static_cast<std::byte>(value & 0xffU));
}

}  // namespace

void AnimatedPng::add(const Image& frame) {
    Image next = withComponents(withType(frame, Component::u8), kPixel);
    if (frames_.empty()) {
        frames_.push_back({0, 0, 1, next});
    } else if (const Bounds bounds = differenceOf(last_, next); !bounds.isEmpty()) {
        frames_.push_back({bounds.left, bounds.top, 1, partOf(next, bounds)});
    } else {
        ++frames_.back().lasts;
    }
    last_ = std::move(next);
}

std::vector<std::byte> AnimatedPng::finish() const {
    if (frames_.empty()) return {};
    std::vector<std::byte> png;
    putPngHeader(png, frames_.front().part);
    std::vector<std::byte> content;
    putBig32(content, static_cast<std::uint32_t>(frames_.size()));
    putBig32(content, 0);  // plays for ever
    putPngChunk(png, "acTL", content);
    std::uint32_t sequence = 0;
    for (const Frame& each : frames_) {
        content.clear();
        putBig32(content, sequence++);
        putBig32(content, static_cast<std::uint32_t>(each.part.width));
        putBig32(content, static_cast<std::uint32_t>(each.part.height));
        putBig32(content, static_cast<std::uint32_t>(each.left));
        putBig32(content, static_cast<std::uint32_t>(each.top));
        constexpr double kMilliseconds = 1000, kLongest = 65'535;
        putBig16(content, static_cast<std::uint32_t>(std::clamp(
                              std::round(kMilliseconds * each.lasts / framesPerSecond_), 1.0, kLongest)));
        putBig16(content, static_cast<std::uint32_t>(kMilliseconds));
        content.insert(content.end(), 2, std::byte{0});  // what is there stays, and the part replaces it
        putPngChunk(png, "fcTL", content);
        const std::vector<std::byte> data = packPngData(each.part, kSmallest, 1);
        if (data.empty()) return {};
        if (&each == &frames_.front()) {
            putPngChunk(png, "IDAT", data);
            continue;
        }
        content.clear();
        putBig32(content, sequence++);
        content.insert(content.end(), data.begin(), data.end());
        putPngChunk(png, "fdAT", content);
    }
    putPngChunk(png, "IEND", {});
    return png;
}

}  // namespace glibra::image
