#include "image/png/packed_size.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

namespace glibra::image {
namespace {

constexpr std::size_t kShortest = 4, kLongest = 258;
constexpr std::size_t kDeflateWindow = 32768;

/// The number of equal bytes after the first four; `end` is the end of the later text.
std::size_t matchLength(const std::uint8_t* earlier, const std::uint8_t* later, const std::uint8_t* end) {
    const auto most = std::min(kLongest, static_cast<std::size_t>(end - later));
    std::size_t length = kShortest;
    for (; length + 8 <= most; length += 8) {
        std::uint64_t a = 0, b = 0;
        std::memcpy(&a, earlier + length, 8);
        std::memcpy(&b, later + length, 8);
        if (a == b) continue;
        const int same =
            std::endian::native == std::endian::little ? std::countr_zero(a ^ b) : std::countl_zero(a ^ b);
        return length + static_cast<std::size_t>(same) / 8;
    }
    while (length < most && earlier[length] == later[length]) ++length;
    return length;
}

double entropyBits(std::span<const std::uint32_t> counts) {
    double sum = 0, all = 0;
    for (const std::uint32_t each : counts) {
        if (each == 0) continue;
        const double count = each;
        all += count;
        sum += count * std::log2(count);
    }
    return all > 0 ? all * std::log2(all) - sum : 0;
}

}  // namespace

void PackedSize::readTo(const std::uint8_t* text, std::size_t end) {
    std::size_t at = at_;
    while (at + 8 <= end) {
        std::uint32_t four = 0;
        std::memcpy(&four, text + at, 4);
        std::uint32_t& last = last_[four * 0x9e3779b1U >> (32 - kHashBits)];
        const std::size_t earlier = last - std::size_t{1}, distance = at - earlier;
        std::uint32_t earlierFour = ~four;
        if (last != 0) std::memcpy(&earlierFour, text + earlier, 4);
        last = static_cast<std::uint32_t>(at + 1);
        if (earlierFour != four || distance > kDeflateWindow) {
            ++symbols_[text[at++]];
            continue;
        }
        const std::size_t length = matchLength(text + earlier, text + at, text + end);
        addLength(length);
        addDistance(distance);
        at += length;
    }
    at_ = at;
}

void PackedSize::addLength(std::size_t length) {
    if (length == kLongest) {
        ++symbols_[285];
    } else if (length < 7) {
        ++symbols_[254 + length];
    } else {
        const auto extra = static_cast<unsigned>(std::bit_width(length - 3)) - 3;
        ++symbols_[257 + std::size_t{4} * extra + ((length - 3) >> extra)];
        extraBits_ += extra;
    }
}

void PackedSize::addDistance(std::size_t distance) {
    if (distance < 3) {
        ++distances_[distance - 1];
    } else {
        const auto extra = static_cast<unsigned>(std::bit_width(distance - 1)) - 2;
        ++distances_[std::size_t{2} * extra + ((distance - 1) >> extra)];
        extraBits_ += extra;
    }
}

void PackedSize::startCounting() {
    symbols_.fill(0);
    distances_.fill(0);
    extraBits_ = 0;
}

double PackedSize::bits() const {
    return entropyBits(symbols_) + entropyBits(distances_) + static_cast<double>(extraBits_);
}

}  // namespace glibra::image
