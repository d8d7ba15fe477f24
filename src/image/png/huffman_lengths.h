#pragma once
// Huffman codes as DEFLATE stores them (RFC 1951, section 3.2.2).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace glibra::image {

/// Sets the length of the code of every symbol, in bits; 0 for symbols with a count of 0. At least two counts
/// are above 0. No length exceeds `most`; if that shortens codes, the lengths are close to the best ones but
/// may miss them.
void chooseCodeLengths(std::span<const std::uint32_t> counts, unsigned most, std::span<std::uint8_t> lengths);

struct Code {
    std::uint16_t bits = 0;  ///< the first bit to write is the lowest
    std::uint16_t length = 0;
};

/// The canonical codes of these lengths (at most 15).
void assignCodes(std::span<const std::uint8_t> lengths, std::span<Code> codes);

}  // namespace glibra::image
