#include "image/png/quick_deflate.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "image/bytes.h"
#include "image/png/huffman_lengths.h"

namespace glibra::image {
namespace {

constexpr std::size_t kSymbols = 286;  ///< literals, the end of the block, and lengths
constexpr std::size_t kEndOfBlock = 256;
// Shorter runs save little, since their bytes have short codes, and whether they occur is hard to predict for
// the processor.
constexpr std::size_t kShortestMatch = 8, kLongestMatch = 258;

/// How DEFLATE writes a number: a symbol, and the bits that the symbol leaves open (RFC 1951, section 3.2.5).
struct Split {
    std::uint16_t symbol = 0, extraBits = 0, extra = 0;
};

constexpr Split splitLength(std::size_t length) {
    if (length == kLongestMatch) return {285, 0, 0};
    const auto rest = static_cast<unsigned>(length - 3);
    if (rest < 8) return {static_cast<std::uint16_t>(257 + rest), 0, 0};
    const auto bits = static_cast<unsigned>(std::bit_width(rest)) - 3;
    return {static_cast<std::uint16_t>(257 + 4 * bits + (rest >> bits)), static_cast<std::uint16_t>(bits),
            static_cast<std::uint16_t>(rest & ((1U << bits) - 1))};
}

constexpr Split splitDistance(std::size_t distance) {
    const auto rest = static_cast<unsigned>(distance - 1);
    if (rest < 4) return {static_cast<std::uint16_t>(rest), 0, 0};
    const auto bits = static_cast<unsigned>(std::bit_width(rest)) - 2;
    return {static_cast<std::uint16_t>(2 * bits + (rest >> bits)), static_cast<std::uint16_t>(bits),
            static_cast<std::uint16_t>(rest & ((1U << bits) - 1))};
}

constexpr auto kLengths = [] {
    std::array<Split, kLongestMatch + 1> table{};
    for (std::size_t i = 3; i <= kLongestMatch; ++i) table[i] = splitLength(i);
    return table;
}();

/// Bits to bytes, the lowest bit first. The destination has eight bytes more than are written.
class BitWriter {
  public:
    BitWriter(std::uint8_t* to, std::uint64_t bits, unsigned count) : to_(to), bits_(bits), count_(count) {}

    /// At most 56 bits.
    void put(std::uint64_t bits, unsigned count) {
        bits_ |= bits << count_;
        count_ += count;
        static_assert(std::endian::native == std::endian::little);
        std::memcpy(to_, &bits_, sizeof bits_);
        to_ += count_ / 8;
        bits_ >>= count_ & ~7U;
        count_ &= 7U;
    }
    void put(Code code) { put(code.bits, code.length); }

    [[nodiscard]] const std::uint8_t* end() const { return to_; }
    [[nodiscard]] std::uint64_t bits() const { return bits_; }
    [[nodiscard]] unsigned count() const { return count_; }

  private:
    std::uint8_t* to_;
    std::uint64_t bits_;
    unsigned count_;
};

std::uint64_t load(const std::uint8_t* from) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, from, sizeof bytes);
    return bytes;
}

/// How many bytes at `at` are equal to those `distance` before, from kShortestMatch up to `most`; 0 if fewer.
std::size_t runLength(const std::uint8_t* at, std::size_t distance, std::size_t most) {
    if (most < kShortestMatch || load(at) != load(at - distance)) return 0;
    std::size_t length = kShortestMatch;
    while (length + 8 <= most && load(at + length) == load(at + length - distance)) length += 8;
    while (length < most && at[length] == at[length - distance]) ++length;
    return length;
}

/// The codes of a block, as its header describes them (RFC 1951, section 3.2.7): first the lengths of the
/// codes of code lengths, then the code lengths, without abbreviations for repeated ones. One distance has a
/// code.
void writeCodes(BitWriter& to, std::span<const std::uint8_t> lengths, std::size_t distanceSymbol) {
    std::vector<std::uint8_t> all(lengths.begin(), lengths.end());
    all.resize(all.size() + distanceSymbol, 0);
    all.push_back(1);
    std::array<std::uint32_t, 19> counts{};
    for (const std::uint8_t each : all) ++counts.at(each);
    std::array<std::uint8_t, 19> metaLengths{};
    std::array<Code, 19> metaCodes{};
    chooseCodeLengths(counts, 7, metaLengths);
    assignCodes(metaLengths, metaCodes);

    to.put(kSymbols - 257, 5);
    to.put(distanceSymbol, 5);
    to.put(19 - 4, 4);
    for (const std::size_t each : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15})
        to.put(metaLengths.at(each), 3);
    for (const std::uint8_t each : all) to.put(metaCodes.at(each));
}

/// How often each symbol occurs in a block with these tokens.
std::array<std::uint32_t, kSymbols> countSymbols(std::span<const std::uint16_t> tokens) {
    // Two tables, so that equal tokens in a row do not wait for each other.
    std::array<std::array<std::uint32_t, 256 + kLongestMatch + 1>, 2> tokenCounts{};
    for (std::size_t i = 0; i < tokens.size(); ++i) ++tokenCounts[i % 2][tokens[i]];
    const auto countOf = [&](std::size_t token) { return tokenCounts[0][token] + tokenCounts[1][token]; };
    std::array<std::uint32_t, kSymbols> counts{};
    for (std::size_t i = 0; i < 256; ++i) counts[i] = countOf(i);
    counts[kEndOfBlock] = 1;
    for (std::size_t i = kShortestMatch; i <= kLongestMatch; ++i)
        counts.at(kLengths[i].symbol) += countOf(256 + i);
    return counts;
}

/// All matches have the same distance. Its code, the only one, is one bit: 0.
void writeTokens(BitWriter& writer, std::span<const std::uint16_t> tokens,
                 const std::array<Code, kSymbols>& codes, Split distance) {
    BitWriter to = writer;  // a local object stays in registers
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const std::size_t token = tokens[i];
        if (token < 256) {
            Code code = codes[token];
            std::uint64_t bits = code.bits;
            unsigned count = code.length;
            // Up to three literals at once.
            for (int more = 0; more < 2 && i + 1 < tokens.size() && tokens[i + 1] < 256; ++more) {
                code = codes[tokens[++i]];
                bits |= std::uint64_t{code.bits} << count;
                count += code.length;
            }
            to.put(bits, count);
            continue;
        }
        const Split& length = kLengths.at(token - 256);
        const Code code = codes.at(length.symbol);
        to.put(code.bits | std::uint64_t{length.extra} << code.length, code.length + length.extraBits);
        to.put(std::uint64_t{distance.extra} << 1U, 1U + distance.extraBits);
    }
    writer = to;
}

}  // namespace

QuickPacker::QuickPacker(std::size_t pixelBytes)
    : pixelBytes_(pixelBytes), stream_{std::byte{0x78}, std::byte{0x01}} {}

void QuickPacker::findRuns(std::span<const std::uint8_t> bytes) {
    tokens_.resize(bytes.size());
    std::uint16_t* to = tokens_.data();
    const std::uint8_t* const begin = bytes.data();
    const std::uint8_t* const end = begin + bytes.size();
    const std::uint8_t* at = begin;
    while (at < end && at < begin + pixelBytes_) *to++ = *at++;
    while (at < end) {
        const auto most = std::min(kLongestMatch, static_cast<std::size_t>(end - at));
        const std::size_t length = runLength(at, pixelBytes_, most);
        *to++ = length > 0 ? static_cast<std::uint16_t>(256 + length) : *at;
        at += std::max<std::size_t>(length, 1);
    }
    tokens_.resize(static_cast<std::size_t>(to - tokens_.data()));
}

void QuickPacker::writeBlock() {
    std::array<std::uint8_t, kSymbols> lengths{};
    std::array<Code, kSymbols> codes{};
    chooseCodeLengths(countSymbols(tokens_), 15, lengths);
    assignCodes(lengths, codes);
    const Split distance = splitDistance(pixelBytes_);

    // No token takes more than 15 bits for its code, 5 for the rest of a length and 3 for the distance.
    block_.resize(3 * tokens_.size() + 1024);
    BitWriter to(block_.data(), bits_, bitCount_);
    to.put(0b100, 3);  // not the last block; codes of its own
    writeCodes(to, lengths, distance.symbol);
    writeTokens(to, tokens_, codes, distance);
    to.put(codes[kEndOfBlock]);
    const auto written = std::as_bytes(std::span<const std::uint8_t>(block_.data(), to.end()));
    stream_.insert(stream_.end(), written.begin(), written.end());
    bits_ = to.bits();
    bitCount_ = to.count();
}

void QuickPacker::add(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return;
    adler_ = libdeflate_adler32(adler_, bytes.data(), bytes.size());
    findRuns(bytes);
    writeBlock();
}

std::vector<std::byte> QuickPacker::finish() {
    // An empty last block with the fixed codes: 1, 01, and seven zeros for its end; then whole bytes.
    std::array<std::uint8_t, 16> last{};
    BitWriter to(last.data(), bits_, bitCount_);
    to.put(0b011, 10);
    to.put(0, (8 - to.count()) % 8);
    const auto written = std::as_bytes(std::span<const std::uint8_t>(last.data(), to.end()));
    stream_.insert(stream_.end(), written.begin(), written.end());
    putBig32(stream_, adler_);
    return std::move(stream_);
}

}  // namespace glibra::image
