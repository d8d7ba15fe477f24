#include "image/png/png_data.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>

#include "base/parallel.h"
#include "image/bytes.h"
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

}  // namespace

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

}  // namespace glibra::image
