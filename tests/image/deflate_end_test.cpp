// Streams of libdeflate that are joined, and read by libdeflate's decoder.

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <bit>
#include <memory>
#include <set>
#include <vector>

#include "image/png/deflate_end.h"
#include "support.h"

namespace glibra::image {
namespace {

using Bytes = std::vector<std::byte>;

Bytes packed(const Bytes& bytes, int level) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    Bytes stream(libdeflate_deflate_compress_bound(compressor.get(), bytes.size()));
    stream.resize(libdeflate_deflate_compress(compressor.get(), bytes.data(), bytes.size(), stream.data(),
                                              stream.size()));
    return stream;
}

/// The content of the stream, if it ends with its last byte.
std::optional<Bytes> unpacked(const Bytes& stream, std::size_t size) {
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    Bytes bytes(size + 1);
    std::size_t read = 0, written = 0;
    if (libdeflate_deflate_decompress_ex(decompressor.get(), stream.data(), stream.size(), bytes.data(),
                                         bytes.size(), &read, &written) != LIBDEFLATE_SUCCESS ||
        read != stream.size())
        return std::nullopt;
    bytes.resize(written);
    return bytes;
}

/// Texts of many kinds: empty, with few and many different bytes, with and without repetitions, up to several
/// blocks.
std::vector<Bytes> texts() {
    std::vector<Bytes> all{{}, Bytes(1, std::byte{7}), Bytes(100'000, std::byte{0})};
    for (std::uint32_t i = 0; i < 40; ++i) {
        Bytes text((i * i * i * 9) % 400'000 + i);
        const std::uint32_t kinds = 2 + testing::hash(i) % 254;
        for (std::size_t at = 0; at < text.size(); ++at) {
            const auto place = static_cast<std::uint32_t>(at);
            text[at] = static_cast<std::byte>(testing::hash(i % 3 == 0 ? place % 3001 : place + i) % kinds);
        }
        all.push_back(std::move(text));
    }
    // Few bytes occur often and many rarely: words of all lengths.
    Bytes skewed(300'000);
    for (std::size_t at = 0; at < skewed.size(); ++at) {
        const std::uint32_t random = testing::hash(static_cast<std::uint32_t>(at));
        skewed[at] = static_cast<std::byte>(random % 1500 == 0 ? static_cast<int>(random >> 24U)
                                                               : std::countr_zero(random | 1U << 20U));
    }
    all.push_back(std::move(skewed));
    // The same for lengths and distances: each occurs half as often as the one before.
    Bytes repeated(40'000);
    for (std::uint32_t i = 0; repeated.size() < 700'000; ++i) {
        const std::uint32_t random = testing::hash(i), other = testing::hash(~i);
        repeated.push_back(static_cast<std::byte>(random >> 24U));
        const std::size_t distance = std::size_t{1} << std::countr_zero(random | 1U << 14U);
        const std::size_t length = 5 + 7 * static_cast<std::size_t>(std::countr_zero(other | 1U << 20U));
        for (std::size_t k = 0; k < length; ++k) repeated.push_back(repeated[repeated.size() - distance]);
    }
    all.push_back(std::move(repeated));
    return all;
}

TEST(DeflateEnd, IsTheEndOfTheStream) {
    for (const Bytes& text : texts())
        for (const int level : {0, 1, 4, 6, 9, 12}) {
            Bytes stream = packed(text, level);
            const std::size_t size = stream.size();
            stream.resize(size + 9, std::byte{0x5a});  // other bytes after it
            const auto found = findDeflateEnd(stream);
            ASSERT_TRUE(found) << text.size() << ' ' << level;
            EXPECT_EQ((found->end + 7) / 8, size) << text.size() << ' ' << level;
            EXPECT_LT(found->lastBlock + 9, found->end);
        }
}

TEST(DeflateEnd, AnotherStreamCanFollowIt) {
    std::set<std::size_t> places;  // the bits of the last byte at which streams end
    const auto all = texts();
    for (const int level : {0, 1, 4, 9})
        for (std::size_t i = 0; i + 2 < all.size(); ++i) {
            Bytes joined, whole;
            for (std::size_t part = i; part < i + 3; ++part) {
                Bytes stream = packed(all[part], level);
                places.insert(findDeflateEnd(stream)->end % 8);
                EXPECT_TRUE(part == i + 2 || makeContinuable(stream));
                joined.insert(joined.end(), stream.begin(), stream.end());
                whole.insert(whole.end(), all[part].begin(), all[part].end());
            }
            EXPECT_EQ(unpacked(joined, whole.size()), whole) << i << ' ' << level;
        }
    EXPECT_EQ(places.size(), 8U) << "every place was tried";
}

TEST(DeflateEnd, OfACutStreamIsNotFound) {
    const Bytes stream = packed(texts()[20], 6);
    for (std::size_t size = 0; size < stream.size(); size += 1 + size / 50)
        EXPECT_FALSE(findDeflateEnd(std::span(stream).first(size))) << size;
}

TEST(DeflateEnd, OfAnyBytesIsFoundOrNot) {
    for (std::uint32_t i = 0; i < 3000; ++i) {
        Bytes bytes(1 + testing::hash(i) % 200);
        for (std::size_t at = 0; at < bytes.size(); ++at)
            bytes[at] = static_cast<std::byte>(testing::hash(1000 * i + static_cast<std::uint32_t>(at)));
        const auto found = findDeflateEnd(bytes);
        if (!found) continue;
        EXPECT_LE(found->end, 8 * bytes.size());
        EXPECT_LT(found->lastBlock, found->end);
    }
}

}  // namespace
}  // namespace glibra::image
