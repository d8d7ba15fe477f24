#include "image/png/png_writer.h"

#include <libdeflate.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>

#include "base/parallel.h"
#include "image/bytes.h"
#include "image/png/deflate_end.h"
#include "system/processors.h"

namespace glibra::image {
namespace {

constexpr std::size_t kShortestMatch = 4, kLongestMatch = 258;
constexpr std::size_t kDeflateWindow = 32768;

/// The number of equal bytes after the first four; `end` is the end of the later text.
std::size_t matchLength(const std::uint8_t* earlier, const std::uint8_t* later, const std::uint8_t* end) {
    const auto most = std::min(kLongestMatch, static_cast<std::size_t>(end - later));
    std::size_t length = kShortestMatch;
    for (; length + 8 <= most; length += 8) {
        std::uint64_t a = 0, b = 0;
        std::memcpy(&a, earlier + length, 8);
        std::memcpy(&b, later + length, 8);
        if (a == b) continue;
        const int same =
            std::endian::native == std::endian::little ? std::countr_zero(a ^ b) : std::countl_zero(a ^ b);
        return length + static_cast<std::size_t>(same) / 8;
    }
    while (length < most && earlier[length] == later[length]) ++length;
    return length;
}

double entropyBits(std::span<const std::uint32_t> counts) {
    double sum = 0, all = 0;
    for (const std::uint32_t each : counts) {
        if (each == 0) continue;
        const double count = each;
        all += count;
        sum += count * std::log2(count);
    }
    return all > 0 ? all * std::log2(all) - sum : 0;
}

}  // namespace

void PackedSize::readTo(const std::uint8_t* text, std::size_t end) {
    std::size_t at = at_;
    while (at + 8 <= end) {
        std::uint32_t four = 0;
        std::memcpy(&four, text + at, 4);
        std::uint32_t& last = last_[four * 0x9e3779b1U >> (32 - kHashBits)];
        const std::size_t earlier = last - std::size_t{1}, distance = at - earlier;
        std::uint32_t earlierFour = ~four;
        if (last != 0) std::memcpy(&earlierFour, text + earlier, 4);
        last = static_cast<std::uint32_t>(at + 1);
        if (earlierFour != four || distance > kDeflateWindow) {
            ++symbols_[text[at++]];
            continue;
        }
        const std::size_t length = matchLength(text + earlier, text + at, text + end);
        addLength(length);
        addDistance(distance);
        at += length;
    }
    at_ = at;
}

void PackedSize::addLength(std::size_t length) {
    if (length == kLongestMatch) {
        ++symbols_[285];
    } else if (length < 7) {
        ++symbols_[254 + length];
    } else {
        const auto extra = static_cast<unsigned>(std::bit_width(length - 3)) - 3;
        ++symbols_[257 + std::size_t{4} * extra + ((length - 3) >> extra)];
        extraBits_ += extra;
    }
}

void PackedSize::addDistance(std::size_t distance) {
    if (distance < 3) {
        ++distances_[distance - 1];
    } else {
        const auto extra = static_cast<unsigned>(std::bit_width(distance - 1)) - 2;
        ++distances_[std::size_t{2} * extra + ((distance - 1) >> extra)];
        extraBits_ += extra;
    }
}

void PackedSize::startCounting() {
    symbols_.fill(0);
    distances_.fill(0);
    extraBits_ = 0;
}

double PackedSize::bits() const {
    return entropyBits(symbols_) + entropyBits(distances_) + static_cast<double>(extraBits_);
}

namespace {

// The loops below are written so that compilers vectorise them: no branches, at most 16 bits, no overlap of
// input and output.

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2")
void subtractLeft(const std::uint8_t* row, std::size_t count, std::size_t pixel,
                  std::uint8_t* __restrict to) {
    std::copy_n(row, pixel, to);
    for (std::size_t i = pixel; i < count; ++i) to[i] = static_cast<std::uint8_t>(row[i] - row[i - pixel]);
}

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2")
void subtractAbove(const std::uint8_t* row, const std::uint8_t* above, std::size_t count,
                   std::uint8_t* __restrict to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(row[i] - above[i]);
}

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2")
void subtractPaeth(const std::uint8_t* row, const std::uint8_t* above, std::size_t count, std::size_t pixel,
                   std::uint8_t* __restrict to) {
    const auto magnitude = [](std::int16_t a) { return static_cast<std::int16_t>(a < 0 ? -a : a); };
    for (std::size_t i = 0; i < pixel; ++i) to[i] = static_cast<std::uint8_t>(row[i] - above[i]);
    for (std::size_t i = pixel; i < count; ++i) {
        const std::int16_t left = row[i - pixel], up = above[i], corner = above[i - pixel];
        const auto overLeft = static_cast<std::int16_t>(up - corner);
        const auto overUp = static_cast<std::int16_t>(left - corner);
        const std::int16_t toLeft = magnitude(overLeft), toUp = magnitude(overUp);
        const std::int16_t toCorner = magnitude(static_cast<std::int16_t>(overLeft + overUp));
        const std::int16_t second = toUp <= toCorner ? up : corner;
        const std::int16_t guess = toLeft <= std::min(toUp, toCorner) ? left : second;
        to[i] = static_cast<std::uint8_t>(row[i] - guess);
    }
}

/// The sum of the absolute values of signed bytes.
GLIBRA_FOR_EACH_PROCESSOR("default", "avx2")
std::uint64_t sumOfSizes(const std::uint8_t* bytes, std::size_t count) {
    constexpr std::size_t kLanes = 32;
    constexpr std::size_t kMostAdded = 511;  // this many values of at most 128 fit into 16 bits
    std::uint64_t sum = 0;
    const auto size = [](std::uint8_t a) { return std::min<std::uint8_t>(a, static_cast<std::uint8_t>(-a)); };
    std::size_t i = 0;
    while (i + kLanes <= count) {
        std::array<std::uint16_t, kLanes> sums{};
        const std::size_t rounds = std::min((count - i) / kLanes, kMostAdded);
        for (std::size_t round = 0; round < rounds; ++round, i += kLanes)
            for (std::size_t lane = 0; lane < kLanes; ++lane)
                sums[lane] = static_cast<std::uint16_t>(sums[lane] + size(bytes[i + lane]));
        for (const std::uint16_t each : sums) sum += each;
    }
    for (; i < count; ++i) sum += size(bytes[i]);
    return sum;
}

std::uint8_t number(PngFilter filter) {
    return static_cast<std::uint8_t>(filter);
}

}  // namespace

PngRowFilter::PngRowFilter(std::size_t rowBytes, std::size_t pixelBytes)
    : rowBytes_(rowBytes), pixelBytes_(pixelBytes), other_(rowBytes) {}

void PngRowFilter::writeBest(const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to) {
    std::uint8_t* best = to + 1;
    subtractAbove(row, above, rowBytes_, best);
    *to = number(PngFilter::up);
    std::uint64_t least = sumOfSizes(best, rowBytes_);
    const auto compare = [&](PngFilter filter) {
        const std::uint64_t sum = sumOfSizes(other_.data(), rowBytes_);
        if (sum >= least) return;
        least = sum;
        *to = number(filter);
        std::copy_n(other_.data(), rowBytes_, best);
    };
    if (least == 0) return;
    std::copy_n(row, rowBytes_, other_.data());
    compare(PngFilter::none);
    subtractLeft(row, rowBytes_, pixelBytes_, other_.data());
    compare(PngFilter::sub);
    subtractPaeth(row, above, rowBytes_, pixelBytes_, other_.data());
    compare(PngFilter::paeth);
}

void PngRowFilter::write(PngFilter filter, const std::uint8_t* row, const std::uint8_t* above,
                         std::uint8_t* to) const {
    *to++ = number(filter);
    switch (filter) {
        case PngFilter::none:
            std::copy_n(row, rowBytes_, to);
            return;
        case PngFilter::sub:
            return subtractLeft(row, rowBytes_, pixelBytes_, to);
        case PngFilter::up:
            return subtractAbove(row, above, rowBytes_, to);
        case PngFilter::paeth:
            return subtractPaeth(row, above, rowBytes_, pixelBytes_, to);
    }
}

namespace {

/// Gives rows in PNG's byte order. A row is valid until the next but one is requested.
class Rows {
  public:
    explicit Rows(const Image& image)
        : image_(image), swaps_(image.type != Component::u8 && std::endian::native == std::endian::little) {
        for (auto& each : swapped_) each.resize(swaps_ ? image.rowBytes() : 0);
        zeros_.resize(image.rowBytes());
    }

    /// -1: the row above the first.
    const std::uint8_t* at(int y) {
        if (y < 0) return zeros_.data();
        const auto from = image_.row(y);
        if (!swaps_) return reinterpret_cast<const std::uint8_t*>(from.data());
        std::vector<std::uint8_t>& to = swapped_[static_cast<std::size_t>(y) % 2];
        for (std::size_t i = 0; i < from.size(); i += 2) {
            to[i] = std::to_integer<std::uint8_t>(from[i + 1]);
            to[i + 1] = std::to_integer<std::uint8_t>(from[i]);
        }
        return to.data();
    }

  private:
    const Image& image_;
    bool swaps_;
    std::array<std::vector<std::uint8_t>, 2> swapped_;
    std::vector<std::uint8_t> zeros_;
};

std::size_t pixelBytes(const Image& image) {
    return static_cast<std::size_t>(image.components) * bytesOf(image.type);
}

/// A way to filter, and the estimated size of sampled rows that are filtered in this way and packed.
struct Candidate {
    PngFiltering filtering = PngFiltering::none;
    double bits = 0;
};

/// Consecutive rows, since most repetitions are found in the rows above: a first half for the second to
/// repeat, and the second half, whose size counts.
struct Sample {
    int firstRow = 0, rows = 0, judgedFrom = 0;
};

std::vector<Sample> samplesOf(std::size_t rowSize, int firstRow, int rows) {
    constexpr std::size_t kHalfBytes = std::size_t{18} << 10;  // DEFLATE looks back 32 KiB
    constexpr std::size_t kPeriodBytes = std::size_t{256} << 10;
    const auto half = static_cast<int>(std::clamp<std::size_t>(kHalfBytes / rowSize, 1, 65536));
    const int all = std::min(rows, 2 * half);
    const std::size_t period = std::max(kPeriodBytes, 7 * rowSize * static_cast<std::size_t>(all));
    const auto count = static_cast<int>(
        std::max<std::size_t>(1, (rowSize * static_cast<std::size_t>(rows) + period / 2) / period));
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        const int middle = static_cast<int>(rows * (std::int64_t{2} * i + 1) / (std::int64_t{2} * count));
        const int begin = std::clamp(middle - all / 2, 0, rows - all);
        samples.push_back({firstRow + begin, all, all / 2});
    }
    return samples;
}

}  // namespace

void filterRows(const Image& image, int firstRow, int rows, PngFiltering filtering, std::uint8_t* to) {
    PngRowFilter filter(image.rowBytes(), pixelBytes(image));
    Rows source(image);
    const std::uint8_t* above = source.at(firstRow - 1);
    for (int y = firstRow; y < firstRow + rows; ++y, to += 1 + image.rowBytes()) {
        const std::uint8_t* row = source.at(y);
        switch (filtering) {
            case PngFiltering::none:
                filter.write(PngFilter::none, row, above, to);
                break;
            case PngFiltering::sub:
                filter.write(PngFilter::sub, row, above, to);
                break;
            case PngFiltering::up:
                filter.write(PngFilter::up, row, above, to);
                break;
            case PngFiltering::bestOfEachRow:
                filter.writeBest(row, above, to);
                break;
        }
        above = row;
    }
}

PngFiltering chooseFiltering(const Image& image, int firstRow, int rows) {
    constexpr double kMuchLonger = 1.1;
    // Packers find more matches than PackedSize does, and unfiltered rows have the most. The factor made the
    // files of 68 pictures half a percent smaller.
    constexpr double kOfUnfiltered = .95;
    const std::size_t rowSize = 1 + image.rowBytes();
    const std::vector<Sample> samples = samplesOf(rowSize, firstRow, rows);
    const std::size_t most = rowSize * static_cast<std::size_t>(samples.front().rows);
    const auto filtered = std::make_unique_for_overwrite<std::uint8_t[]>(most);
    const auto packed = std::make_unique<PackedSize>();
    std::vector<Candidate> candidates{
        {PngFiltering::bestOfEachRow}, {PngFiltering::none}, {PngFiltering::sub}, {PngFiltering::up}};
    const auto isShorter = [](const Candidate& a, const Candidate& b) { return a.bits < b.bits; };
    for (const Sample& sample : samples) {
        for (Candidate& each : candidates) {
            filterRows(image, sample.firstRow, sample.rows, each.filtering, filtered.get());
            *packed = {};
            packed->readTo(filtered.get(), rowSize * static_cast<std::size_t>(sample.judgedFrom));
            packed->startCounting();
            packed->readTo(filtered.get(), rowSize * static_cast<std::size_t>(sample.rows));
            each.bits += packed->bits() * (each.filtering == PngFiltering::none ? kOfUnfiltered : 1);
        }
        const double least = std::min_element(candidates.begin(), candidates.end(), isShorter)->bits;
        std::erase_if(candidates, [&](const Candidate& each) { return each.bits > kMuchLonger * least; });
    }
    return std::min_element(candidates.begin(), candidates.end(), isShorter)->filtering;
}

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
