#include "image/png/deflate_end.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace glibra::image {
namespace {

constexpr std::size_t kLiteralSymbols = 288;
constexpr std::size_t kDistanceSymbols = 32;
constexpr unsigned kLongestCode = 15;
constexpr std::uint16_t kEndOfBlock = 256;

/// The next bits, lowest first; zeros after the end.
class BitReader {
  public:
    explicit BitReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    /// At least 57 bits.
    [[nodiscard]] std::uint64_t peek() const {
        const std::size_t at = position_ / 8;
        std::uint64_t word = 0;
        if (std::endian::native == std::endian::little && at + 8 <= bytes_.size())
            std::memcpy(&word, bytes_.data() + at, 8);
        else
            for (std::size_t i = 0; i < 8 && at + i < bytes_.size(); ++i)
                word |= std::to_integer<std::uint64_t>(bytes_[at + i]) << 8 * i;
        return word >> position_ % 8;
    }
    void skip(std::size_t bits) { position_ += bits; }
    std::uint32_t take(unsigned bits) {
        const auto value = static_cast<std::uint32_t>(peek() & ((std::uint64_t{1} << bits) - 1));
        skip(bits);
        return value;
    }
    [[nodiscard]] std::size_t position() const { return position_; }
    [[nodiscard]] bool isPastEnd() const { return position_ > 8 * bytes_.size(); }

  private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

/// The number of extra bits of a length symbol (RFC 1951, 3.2.5).
unsigned extraOfLength(std::size_t symbol) {
    return symbol < 265 || symbol == 285 ? 0U : static_cast<unsigned>(symbol - 261) / 4;
}
unsigned extraOfDistance(std::size_t symbol) {
    return symbol < 4 ? 0U : static_cast<unsigned>(symbol - 2) / 2;
}

/// A Huffman code; its words are in the order of their lengths.
class Code {
  public:
    /// False if the lengths need more words than exist.
    bool build(std::span<const std::uint8_t> lengths) {
        counts_ = {};
        for (const std::uint8_t each : lengths) ++counts_[each];
        counts_[0] = 0;
        std::array<std::uint16_t, kLongestCode + 1> next{};
        std::uint32_t word = 0;
        for (unsigned length = 1; length <= kLongestCode; ++length) {
            next[length] = static_cast<std::uint16_t>(next[length - 1] + counts_[length - 1]);
            word = (word + counts_[length - 1]) << 1U;
            firsts_[length] = word;
            if (word + counts_[length] > 1U << length) return false;
        }
        begins_ = next;
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol)
            if (lengths[symbol] > 0) symbols_[next[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
        return true;
    }

    /// Reads a word; empty if no word has these bits.
    std::optional<std::uint16_t> take(BitReader& reader) const {
        std::uint64_t bits = reader.peek();
        std::uint32_t word = 0;
        for (unsigned length = 1; length <= kLongestCode; ++length, bits >>= 1U) {
            word = word << 1U | static_cast<std::uint32_t>(bits & 1U);
            if (word - firsts_[length] >= counts_[length]) continue;
            reader.skip(length);
            return symbols_[begins_[length] + word - firsts_[length]];
        }
        return std::nullopt;
    }

    /// Calls `use(symbol, length, bits)` for every word; `bits` is the word as it is read, lowest bit first.
    template <class Use>
    void forEach(unsigned longest, const Use& use) const {
        for (unsigned length = 1; length <= longest; ++length)
            for (std::uint32_t i = 0; i < counts_[length]; ++i)
                use(symbols_[begins_[length] + i], length, reversed(firsts_[length] + i, length));
    }

  private:
    static std::uint32_t reversed(std::uint32_t word, unsigned length) {
        std::uint32_t result = 0;
        for (unsigned i = 0; i < length; ++i) result |= (word >> i & 1U) << (length - 1 - i);
        return result;
    }

    std::array<std::uint16_t, kLongestCode + 1> counts_{}, begins_{};  ///< by length
    std::array<std::uint32_t, kLongestCode + 1> firsts_{};             ///< the first word of a length
    std::array<std::uint16_t, kLiteralSymbols> symbols_{};
};

/// How many bits to skip in a block, by its next bits: as many literals as they hold and a length after them,
/// or a distance.
class Steps {
  public:
    /// The number of bits that select a step; the words of a step end within them.
    static constexpr unsigned kBits = 11;
    /// A flag in a step: a distance is next. The lowest six bits are the number of bits to skip; 0 for the
    /// end of a block and for longer words, which the table does not cover.
    static constexpr std::uint16_t kToDistance = 1U << kBits;

    void build(const Code& literals, const Code& distances) {
        struct Word {
            std::uint16_t symbol = 0;
            std::uint8_t bits = 0;
        };
        std::array<Word, kCount> words{};
        const auto fill = [](std::uint32_t bits, unsigned length, const auto& put) {
            for (std::size_t i = bits; i < kCount; i += std::size_t{1} << length) put(i);
        };
        literals.forEach(kBits, [&](std::uint16_t symbol, unsigned length, std::uint32_t bits) {
            fill(bits, length,
                 [&](std::size_t i) { words[i] = {symbol, static_cast<std::uint8_t>(length)}; });
        });
        for (std::size_t i = 0; i < kCount; ++i) {
            unsigned used = 0;
            Word word = words[i];
            while (word.bits > 0 && word.symbol < kEndOfBlock && used + word.bits <= kBits) {
                used += word.bits;
                word = words[i >> used];
            }
            const bool isLength = word.bits > 0 && word.symbol > kEndOfBlock && used + word.bits <= kBits;
            if (isLength) used += word.bits + extraOfLength(word.symbol);
            steps_[i] = static_cast<std::uint16_t>(used | (isLength ? kToDistance : 0U));
        }
        std::fill_n(steps_.begin() + kCount, kCount, kToDistance);
        distances.forEach(kBits, [&](std::uint16_t symbol, unsigned length, std::uint32_t bits) {
            fill(bits, length, [&](std::size_t i) {
                steps_[kCount + i] = static_cast<std::uint16_t>(length + extraOfDistance(symbol));
            });
        });
    }

    /// The step after `last` (0 at the start of a block) if these are the next bits.
    [[nodiscard]] std::uint16_t next(std::uint16_t last, std::uint64_t bits) const {
        return steps_[(last & kToDistance) | (bits & (kCount - 1))];
    }

  private:
    static constexpr std::size_t kCount = std::size_t{1} << kBits;
    std::array<std::uint16_t, 2 * kCount> steps_{};
};

class Walk {
  public:
    explicit Walk(std::span<const std::byte> stream) : reader_(stream) {}

    std::optional<DeflateEnd> run() {
        for (bool isLast = false; !isLast;) {
            const std::size_t start = reader_.position();
            isLast = reader_.take(1) == 1;
            if (!passBlock(reader_.take(2)) || reader_.isPastEnd()) return std::nullopt;
            if (isLast) return DeflateEnd{start, reader_.position()};
        }
        return std::nullopt;
    }

  private:
    bool passBlock(std::uint32_t type) {
        switch (type) {
            case 0:
                return passStored();
            case 1:
                return useFixedCodes() && passSymbols();
            case 2:
                return readCodes() && passSymbols();
            default:
                return false;
        }
    }

    bool passStored() {
        reader_.skip((8 - reader_.position() % 8) % 8);
        const std::uint32_t length = reader_.take(16);
        if (reader_.take(16) != (length ^ 0xffffU)) return false;
        reader_.skip(std::size_t{8} * length);
        return true;
    }

    bool useFixedCodes() {
        std::array<std::uint8_t, kLiteralSymbols> lengths{};
        for (std::size_t i = 0; i < lengths.size(); ++i)
            lengths[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
        std::array<std::uint8_t, kDistanceSymbols> distances{};
        distances.fill(5);
        return literals_.build(lengths) && distances_.build(distances);
    }

    /// The codes of a block; their lengths are packed too (RFC 1951, 3.2.7).
    bool readCodes() {
        constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                      11, 4,  12, 3, 13, 2, 14, 1, 15};
        const std::size_t literals = 257 + reader_.take(5);
        const std::size_t distances = 1 + reader_.take(5);
        const std::size_t given = 4 + reader_.take(4);
        std::array<std::uint8_t, 19> codeLengths{};
        for (std::size_t i = 0; i < given; ++i)
            codeLengths[kOrder[i]] = static_cast<std::uint8_t>(reader_.take(3));
        Code codes;
        if (!codes.build(codeLengths)) return false;
        std::array<std::uint8_t, kLiteralSymbols + kDistanceSymbols> lengths{};
        const std::size_t all = literals + distances;
        for (std::size_t i = 0; i < all;) {
            const auto symbol = codes.take(reader_);
            if (!symbol) return false;
            if (*symbol < 16) {
                lengths[i++] = static_cast<std::uint8_t>(*symbol);
                continue;
            }
            if (*symbol == 16 && i == 0) return false;
            const std::uint8_t repeated = *symbol == 16 ? lengths[i - 1] : std::uint8_t{0};
            const std::size_t count = *symbol == 16   ? 3 + reader_.take(2)
                                      : *symbol == 17 ? 3 + reader_.take(3)
                                                      : 11 + reader_.take(7);
            if (count > all - i) return false;
            std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(i), count, repeated);
            i += count;
        }
        const std::span<const std::uint8_t> found(lengths);
        return literals_.build(found.first(literals)) && distances_.build(found.subspan(literals, distances));
    }

    bool passSymbols() {
        steps_.build(literals_, distances_);
        std::uint16_t step = 0;
        while (!reader_.isPastEnd()) {
            // Three steps per look-up: no two distances are adjacent, so the third word starts before bit 41
            // of 57. Steps that the table does not cover skip no bits.
            const std::uint64_t bits = reader_.peek();
            const std::uint16_t first = steps_.next(step, bits);
            const unsigned firstBits = first & kStepBits;
            const std::uint16_t second = steps_.next(first, bits >> firstBits);
            const unsigned secondBits = firstBits + (second & kStepBits);
            step = steps_.next(second, bits >> secondBits);
            reader_.skip(secondBits + (step & kStepBits));
            if ((step & kStepBits) != 0) continue;
            const bool isDistance = (step & Steps::kToDistance) != 0;
            const auto symbol = (isDistance ? distances_ : literals_).take(reader_);
            if (!symbol) return false;
            if (!isDistance && *symbol == kEndOfBlock) return true;
            const bool isLength = !isDistance && *symbol > kEndOfBlock;
            if (isDistance) reader_.skip(extraOfDistance(*symbol));
            if (isLength) reader_.skip(extraOfLength(*symbol));
            step = isLength ? Steps::kToDistance : std::uint16_t{0};
        }
        return false;
    }

    static constexpr unsigned kStepBits = 63;

    BitReader reader_;
    Code literals_, distances_;
    Steps steps_;
};

}  // namespace

std::optional<DeflateEnd> findDeflateEnd(std::span<const std::byte> stream) {
    return Walk(stream).run();
}

bool makeContinuable(std::vector<std::byte>& stream) {
    const auto found = findDeflateEnd(stream);
    if (!found) return false;
    stream.resize((found->end + 7) / 8);
    stream[found->lastBlock / 8] &= static_cast<std::byte>(~(1U << found->lastBlock % 8));
    // The header of a stored block is three zero bits, which the end of the stream may already contain.
    if (found->end % 8 > 5 || found->end % 8 == 0) stream.push_back(std::byte{0});
    const std::size_t used = found->end % 8;
    if (used != 0) {
        std::byte& last = stream[found->end / 8];
        last &= static_cast<std::byte>((1U << used) - 1);
    }
    constexpr std::array kEmpty{std::byte{0}, std::byte{0}, std::byte{0xff}, std::byte{0xff}};
    stream.insert(stream.end(), kEmpty.begin(), kEmpty.end());
    return true;
}

}  // namespace glibra::image
