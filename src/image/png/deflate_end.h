#pragma once
// Where a DEFLATE stream (RFC 1951) ends, so that another can be put behind it. libdeflate packs fastest but
// only whole streams; with this, parts of a picture that several threads packed become one stream.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace glibra::image {

/// Places in a stream, in bits from its start; bit 0 is the lowest of the first byte.
struct DeflateEnd {
    std::size_t lastBlock = 0;  ///< the bit that says that this block is the last
    std::size_t end = 0;        ///< behind the last block
};

/// Nothing if the stream is not whole, or wrong. It is read, not unpacked: distances are not looked at.
std::optional<DeflateEnd> findDeflateEnd(std::span<const std::byte> stream);

/// Makes the stream one that another stream continues: its last block becomes one of many, and an empty
/// stored block leads to the next whole byte. False if the stream is wrong.
bool makeContinuable(std::vector<std::byte>& stream);

}  // namespace glibra::image
