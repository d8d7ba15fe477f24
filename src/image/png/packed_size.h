#pragma once
// Estimates the size of data packed by DEFLATE, in a small part of the time that packing takes.

#include <array>
#include <cstddef>
#include <cstdint>

namespace glibra::image {

/// Searches for matches as a quick packer does, one candidate per position, and adds up the entropy of the
/// matches and of the literals between them. Good for comparing data of one kind: the estimate is some
/// percent more than libdeflate's level 4 needs.
class PackedSize {
  public:
    /// Continues from the previous position to `end` bytes after `text`, whose earlier bytes must be
    /// unchanged. The last seven bytes wait for the next call.
    void readTo(const std::uint8_t* text, std::size_t end);

    /// Counts only from here; the earlier bytes can still be repeated by matches.
    void startCounting();

    /// The bits of everything read, without the descriptions of the codes.
    [[nodiscard]] double bits() const;

  private:
    static constexpr unsigned kHashBits = 13;

    // Four symbols per doubling of the length, two per doubling of the distance; extra bits hold the rest
    // (RFC 1951, 3.2.5).
    void addLength(std::size_t length);
    void addDistance(std::size_t distance);

    std::size_t at_ = 0;
    std::array<std::uint32_t, std::size_t{1} << kHashBits>
        last_{};                                 ///< 1 + the last position of four such bytes
    std::array<std::uint32_t, 286> symbols_{};   ///< DEFLATE's symbols: literals and lengths
    std::array<std::uint32_t, 30> distances_{};  ///< DEFLATE's symbols
    std::uint64_t extraBits_ = 0;
};

}  // namespace glibra::image
