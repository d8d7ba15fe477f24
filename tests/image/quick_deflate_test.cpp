// The packer of frames: libdeflate unpacks what it packs, and the codes are those of Huffman trees.

#include "image/png/quick_deflate.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "image/png/huffman_lengths.h"
#include "support.h"

namespace glibra::image {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<std::byte> pack(const Bytes& bytes, std::size_t pixelBytes, std::size_t pieceBytes) {
    QuickPacker packer(pixelBytes);
    for (std::size_t at = 0; at < bytes.size(); at += pieceBytes)
        packer.add(std::span(bytes).subspan(at, std::min(pieceBytes, bytes.size() - at)));
    return packer.finish();
}

/// Empty if the stream is wrong, its checksum included, or longer or shorter than `size` bytes.
Bytes unpack(const std::vector<std::byte>& stream, std::size_t size) {
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    Bytes bytes(size + 1);
    std::size_t actual = 0;
    const auto result = libdeflate_zlib_decompress(decompressor.get(), stream.data(), stream.size(),
                                                   bytes.data(), bytes.size(), &actual);
    if (result != LIBDEFLATE_SUCCESS || actual != size) return {};
    bytes.resize(size);
    return bytes;
}

/// Runs of up to 1000 bytes of a few kinds, and single random bytes.
Bytes mixed(std::size_t size, std::uint32_t seed) {
    Bytes bytes;
    for (std::uint32_t i = 0; bytes.size() < size; ++i) {
        const std::uint32_t random = testing::hash(seed + i);
        bytes.insert(bytes.end(), random % 3 == 0 ? random / 3 % 1000 : 1,
                     static_cast<std::uint8_t>(random >> 24U));
    }
    bytes.resize(size);
    return bytes;
}

TEST(QuickPacker, IsUnpackedByLibdeflate) {
    for (std::size_t size : {1, 2, 3, 4, 5, 7, 8, 9, 63, 258, 259, 4000, 300000})
        for (std::size_t pixelBytes = 1; pixelBytes <= 8; ++pixelBytes)
            for (const std::size_t piece : {std::size_t{1000}, std::size_t{128} << 10}) {
                const Bytes bytes = mixed(size, static_cast<std::uint32_t>(100 * size + pixelBytes));
                EXPECT_EQ(unpack(pack(bytes, pixelBytes, piece), size), bytes) << size << ' ' << pixelBytes;
            }
    EXPECT_EQ(unpack(pack({}, 3, 1000), 0), Bytes{});
}

TEST(QuickPacker, WritesEveryLengthOfARun) {
    for (std::size_t length = 0; length < 600; ++length) {
        Bytes bytes{1, 2, 3, 9, 9, 9};
        for (std::size_t i = 0; i < length; ++i) bytes.push_back(static_cast<std::uint8_t>(9));
        bytes.insert(bytes.end(), {4, 5});
        EXPECT_EQ(unpack(pack(bytes, 3, bytes.size()), bytes.size()), bytes) << length;
    }
}

TEST(QuickPacker, PacksRandomAndConstantBytesWithinBounds) {
    Bytes random(200000);
    for (std::size_t i = 0; i < random.size(); ++i)
        random[i] = static_cast<std::uint8_t>(testing::hash(static_cast<std::uint32_t>(i)));
    const auto packedRandom = pack(random, 3, std::size_t{128} << 10);
    EXPECT_EQ(unpack(packedRandom, random.size()), random);
    EXPECT_LT(packedRandom.size(), random.size() + random.size() / 200);
    const Bytes constant(200000, 7);
    const auto packedConstant = pack(constant, 4, std::size_t{128} << 10);
    EXPECT_EQ(unpack(packedConstant, constant.size()), constant);
    EXPECT_LT(packedConstant.size(), 800U);
}

/// Fibonacci's numbers as counts make the deepest tree.
std::vector<std::uint32_t> fibonacci(std::size_t count) {
    std::vector<std::uint32_t> counts{1, 1};
    while (counts.size() < count) counts.push_back(counts.back() + counts[counts.size() - 2]);
    return counts;
}

TEST(CodeLengths, AreAFullPrefixCodeWithinTheLimit) {
    for (std::size_t count = 2; count <= 30; ++count) {
        const std::vector<std::uint32_t> counts = fibonacci(count);
        Bytes lengths(count);
        chooseCodeLengths(counts, 15, lengths);
        double sum = 0;
        for (const std::uint8_t each : lengths) {
            EXPECT_GE(each, 1);
            EXPECT_LE(each, 15);
            sum += std::exp2(-each);
        }
        EXPECT_EQ(sum, 1) << "Kraft's equality, " << count << " symbols";
    }
}

TEST(CodeLengths, AreThoseOfTheTextbook) {
    // Cormen, Leiserson, Rivest, Stein: Introduction to Algorithms, figure 16.4.
    const std::array<std::uint32_t, 7> counts{45, 13, 12, 0, 16, 9, 5};
    Bytes lengths(counts.size());
    chooseCodeLengths(counts, 15, lengths);
    EXPECT_EQ(lengths, (Bytes{1, 3, 3, 0, 3, 4, 4}));
}

TEST(CodeLengths, GiveTheCodesOfTheRfc) {
    // RFC 1951, section 3.2.2: 010 011 100 101 110 00 1110 1111, here with the first bit lowest.
    const Bytes lengths{3, 3, 3, 3, 3, 2, 4, 4};
    std::array<Code, 8> codes{};
    assignCodes(lengths, codes);
    const std::array<unsigned, 8> expected{0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(codes.at(i).bits, expected.at(i)) << i;
}

}  // namespace
}  // namespace glibra::image
