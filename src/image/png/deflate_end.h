#pragma once
// Finds the end of a DEFLATE stream (RFC 1951), so that another stream can follow it. libdeflate is the
// fastest packer but makes only complete streams; this joins the parts of a picture that several threads have
// packed.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace glibra::image {

/// Places in a stream, in bits from its start. Bit 0 is the lowest bit of the first byte.
struct DeflateEnd {
    std::size_t lastBlock = 0;  ///< the bit that marks the last block as the last
    std::size_t end = 0;        ///< after the last block
};

/// Empty if the stream is incomplete or wrong. The stream is parsed but not unpacked: distances are not
/// checked.
std::optional<DeflateEnd> findDeflateEnd(std::span<const std::byte> stream);

/// Changes the stream so that another one can follow: its last block is no longer marked as the last, and an
/// empty stored block fills the last byte. False if the stream is wrong.
bool makeContinuable(std::vector<std::byte>& stream);

}  // namespace glibra::image
