#include "image/deflate_end.h"

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

/// The next bits, lowest first; zeros behind the end.
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

struct Entry {
    std::uint16_t symbol = 0;
    std::uint8_t codeBits = 0;  ///< 0: no such code
    std::uint8_t allBits = 0;   ///< with the extra bits, or with the literals behind a literal
};

/// Bits behind the code of a length symbol (RFC 1951, 3.2.5).
unsigned extraOfLength(std::size_t symbol) {
    return symbol < 265 || symbol == 285 ? 0U : static_cast<unsigned>(symbol - 261) / 4;
}
unsigned extraOfDistance(std::size_t symbol) {
    return symbol < 4 ? 0U : static_cast<unsigned>(symbol - 2) / 2;
}
unsigned noExtra(std::size_t) {
    return 0;
}

/// Looks a code word up by the next bits of the stream, whatever follows it.
class CodeTable {
  public:
    /// False if the lengths are of more codes than there are.
    bool build(std::span<const std::uint8_t> lengths, unsigned (*extra)(std::size_t symbol)) {
        std::array<std::uint32_t, kLongestCode + 1> counts{};
        for (const std::uint8_t each : lengths) ++counts[each];
        counts[0] = 0;
        bits_ = 1;
        for (unsigned length = 1; length <= kLongestCode; ++length)
            if (counts[length] > 0) bits_ = length;
        std::array<std::uint32_t, kLongestCode + 1> next{};
        for (unsigned length = 1; length <= kLongestCode; ++length) {
            next[length] = (next[length - 1] + counts[length - 1]) << 1U;
            if (next[length] + counts[length] > 1U << length) return false;
        }
        entries_.assign(std::size_t{1} << bits_, {});
        for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
            const unsigned length = lengths[symbol];
            if (length == 0) continue;
            const std::uint32_t code = reversed(next[length]++, length);
            const Entry entry{static_cast<std::uint16_t>(symbol), static_cast<std::uint8_t>(length),
                              static_cast<std::uint8_t>(length + extra(symbol))};
            for (std::size_t i = code; i < entries_.size(); i += std::size_t{1} << length)
                entries_[i] = entry;
        }
        return true;
    }
    /// Makes one step of as many literals as the looked up bits hold.
    void joinLiterals() {
        for (std::size_t i = 0; i < entries_.size(); ++i) {
            std::size_t rest = i;
            unsigned used = 0;
            for (const Entry* each = &entries_[i];
                 each->symbol < kEndOfBlock && each->codeBits > 0 && used + each->codeBits <= bits_;
                 each = &entries_[rest]) {
                used += each->codeBits;
                rest >>= each->codeBits;
            }
            if (used > 0) entries_[i].allBits = static_cast<std::uint8_t>(used);
        }
    }
    [[nodiscard]] const Entry& find(std::uint64_t bits) const {
        return entries_[bits & (entries_.size() - 1)];
    }

  private:
    static std::uint32_t reversed(std::uint32_t code, unsigned length) {
        std::uint32_t result = 0;
        for (unsigned i = 0; i < length; ++i) result |= (code >> i & 1U) << (length - 1 - i);
        return result;
    }

    std::vector<Entry> entries_;
    unsigned bits_ = 1;
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
        return literals_.build(lengths, extraOfLength) && distances_.build(distances, extraOfDistance);
    }

    /// The codes of a block, whose lengths are packed themselves (RFC 1951, 3.2.7).
    bool readCodes() {
        constexpr std::array<std::uint8_t, 19> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                      11, 4,  12, 3, 13, 2, 14, 1, 15};
        const std::size_t literals = 257 + reader_.take(5);
        const std::size_t distances = 1 + reader_.take(5);
        const std::size_t given = 4 + reader_.take(4);
        std::array<std::uint8_t, 19> codeLengths{};
        for (std::size_t i = 0; i < given; ++i)
            codeLengths[kOrder[i]] = static_cast<std::uint8_t>(reader_.take(3));
        CodeTable codes;
        if (!codes.build(codeLengths, noExtra)) return false;
        std::array<std::uint8_t, kLiteralSymbols + kDistanceSymbols> lengths{};
        const std::size_t all = literals + distances;
        for (std::size_t i = 0; i < all;) {
            const Entry& entry = codes.find(reader_.peek());
            if (entry.codeBits == 0) return false;
            reader_.skip(entry.codeBits);
            if (entry.symbol < 16) {
                lengths[i++] = static_cast<std::uint8_t>(entry.symbol);
                continue;
            }
            if (entry.symbol == 16 && i == 0) return false;
            const std::uint8_t repeated = entry.symbol == 16 ? lengths[i - 1] : std::uint8_t{0};
            const std::size_t count = entry.symbol == 16   ? 3 + reader_.take(2)
                                      : entry.symbol == 17 ? 3 + reader_.take(3)
                                                           : 11 + reader_.take(7);
            if (count > all - i) return false;
            std::fill_n(lengths.begin() + static_cast<std::ptrdiff_t>(i), count, repeated);
            i += count;
        }
        const std::span<const std::uint8_t> found(lengths);
        return literals_.build(found.first(literals), extraOfLength) &&
               distances_.build(found.subspan(literals, distances), extraOfDistance);
    }

    bool passSymbols() {
        literals_.joinLiterals();
        while (!reader_.isPastEnd()) {
            // Three steps fit into the bits of one look: 15 + 15 + 20 of 57.
            std::uint64_t bits = reader_.peek();
            const Entry* entry = &literals_.find(bits);
            std::size_t used = 0;
            for (int i = 0; i < 2 && entry->symbol < kEndOfBlock && entry->codeBits > 0; ++i) {
                used += entry->allBits;
                bits >>= entry->allBits;
                entry = &literals_.find(bits);
            }
            if (entry->codeBits == 0) return false;
            reader_.skip(used + entry->allBits);
            if (entry->symbol == kEndOfBlock) return true;
            if (entry->symbol < kEndOfBlock) continue;
            const Entry& distance = distances_.find(reader_.peek());
            if (distance.codeBits == 0) return false;
            reader_.skip(distance.allBits);
        }
        return false;
    }

    BitReader reader_;
    CodeTable literals_, distances_;
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
    // The header of a stored block is three zero bits; there may be as many behind the end already.
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
