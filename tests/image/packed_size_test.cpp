// The estimate of a packed size, against libdeflate.

#include "image/png/png_writer.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "support.h"

namespace glibra::image {
namespace {

using Text = std::vector<std::uint8_t>;

/// `count` bytes with `kinds` different values, small ones most often; they repeat after `period` bytes.
Text text(std::size_t count, std::uint32_t kinds, std::size_t period) {
    Text result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t random = testing::hash(static_cast<std::uint32_t>(i % period));
        result[i] = static_cast<std::uint8_t>(std::min(random % kinds, (random >> 16U) % kinds));
    }
    return result;
}

double estimated(const Text& text) {
    PackedSize size;
    size.readTo(text.data(), text.size());
    return size.bits() / 8;
}

double libdeflateBytes(const Text& text) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(4), libdeflate_free_compressor);
    Text to(libdeflate_deflate_compress_bound(compressor.get(), text.size()));
    return static_cast<double>(
        libdeflate_deflate_compress(compressor.get(), text.data(), text.size(), to.data(), to.size()));
}

TEST(PackedSize, IsCloseToTheSizeByLibdeflate) {
    for (const std::uint32_t kinds : {40U, 100U, 256U})
        for (const std::size_t period : {1500U, 5000U, 31'000U, 200'000U}) {
            const Text each = text(60'000, kinds, period);
            const double ratio =
                (estimated(each) + 60) /
                (libdeflateBytes(each) +
                 60);  // 60 bytes for the descriptions of the codes, which count in short texts
            EXPECT_GT(ratio, .75) << kinds << ' ' << period;
            EXPECT_LT(ratio, 1.3) << kinds << ' ' << period;
        }
}

TEST(PackedSize, OfOneByteRepeatedIsAlmostZero) {
    EXPECT_LT(estimated(Text(100'000, 7)), 400);
    EXPECT_EQ(estimated({}), 0);
    EXPECT_EQ(estimated(Text(7, 1)), 0);
}

TEST(PackedSize, BytesBeforeTheCountCanBeRepeatedCheaply) {
    const Text twice = text(40'000, 256, 20'000);
    PackedSize size;
    size.readTo(twice.data(), 20'000);
    EXPECT_GT(size.bits() / 8, 15'000);
    size.startCounting();
    EXPECT_EQ(size.bits(), 0);
    size.readTo(twice.data(), 40'000);
    EXPECT_LT(size.bits() / 8, 500);
}

TEST(PackedSize, BytesTooFarBackAreNotRepeated) {
    EXPECT_LT(estimated(text(64'000, 256, 32'000)), 1.2 * 32'000);
    EXPECT_GT(estimated(text(66'000, 256, 33'000)), 1.8 * 33'000);
}

}  // namespace
}  // namespace glibra::image
