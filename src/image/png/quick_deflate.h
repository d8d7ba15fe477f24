#pragma once
// A DEFLATE packer for filtered pixel rows that is several times as fast as a general one. It packs the
// frames of animations, which are drawn faster than a general packer keeps up with.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace glibra::image {

/// Makes a zlib stream (RFC 1950) whose only matches are runs of equal pixels, with Huffman codes made for
/// each block. The same input gives the same bytes on every machine.
class QuickPacker {
  public:
    /// `pixelBytes` (1 to 8) is the distance of all matches.
    explicit QuickPacker(std::size_t pixelBytes);

    /// Adds one block. Blocks of about 128 KiB, which stay in the processor's cache, are the fastest.
    void add(std::span<const std::uint8_t> bytes);
    /// The stream of everything that was added. Call it once.
    std::vector<std::byte> finish();

  private:
    void findRuns(std::span<const std::uint8_t> bytes);
    void writeBlock();

    std::size_t pixelBytes_;
    std::uint32_t adler_ = 1;
    std::vector<std::uint16_t> tokens_;  ///< of a block: a byte, or 256 + the length of a match
    std::vector<std::uint8_t> block_;
    std::vector<std::byte> stream_;
    std::uint64_t bits_ = 0;  ///< of the stream's last byte, which is not whole yet
    unsigned bitCount_ = 0;   ///< 0 to 7
};

}  // namespace glibra::image
