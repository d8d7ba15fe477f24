#pragma once
// A fast reader for the usual OBJ file, and the numbers in it.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

// Decimal numbers as model files write them, read several digits at a time.

/// A run of at most eight digits: its value and its length.
struct Digits {
    std::uint64_t value = 0;
    std::size_t count = 0;
};

/// Reads the run of digits at `at`, where at least eight bytes must be readable; a longer run is cut after
/// eight. All eight bytes are examined together (Lemire, Quickly parsing eight digits, 2018), so the time
/// does not depend on where the run ends.
inline Digits digitsAt(const char* at) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    if constexpr (std::endian::native == std::endian::big) bytes = __builtin_bswap64(bytes);
    const std::uint64_t values = bytes ^ 0x3030303030303030U;  // a digit becomes 0..9, any other byte more
    const std::uint64_t others = ((values + 0x7676767676767676U) | values) & 0x8080808080808080U;
    const auto count = static_cast<std::size_t>(std::countr_zero(others)) / 8;  // 64 / 8 if there is none
    if (count == 0) return {};
    std::uint64_t digits = values << (64 - 8 * count);  // zeros in front
    digits = (digits * 10 + (digits >> 8)) & 0x00ff00ff00ff00ffU;
    digits = (digits * 100 + (digits >> 16)) & 0x0000ffff0000ffffU;
    digits = (digits * 10'000 + (digits >> 32)) & 0xffffffffU;
    return {digits, count};
}

/// The number of bytes that must be readable from the first byte of a number on.
inline constexpr std::size_t kDecimalReach = 48;

/// Reads [+-] digits [. digits] with up to 15 digits at `at`, where kDecimalReach bytes must be readable.
/// `value` becomes the nearest float, the same that std::from_chars gives. Returns the place after the
/// number, or null if there is no number or if it is written in another way (with an exponent, with more
/// digits, as a bare dot).
inline const char* readDecimal(const char* at, float& value) {
    constexpr double kPowers[] = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                  1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = *at == '-';
    if (negative || *at == '+') ++at;
    const Digits whole = digitsAt(at);
    at += whole.count;
    std::uint64_t all = whole.value;
    std::size_t count = whole.count, fraction = 0;
    if (whole.count == 8) return nullptr;
    if (*at == '.') {
        const Digits first = digitsAt(++at);
        at += first.count;
        fraction = first.count;
        constexpr std::uint64_t kWholePowers[] = {1,       10,        100,        1'000,      10'000,
                                                  100'000, 1'000'000, 10'000'000, 100'000'000};
        all = all * kWholePowers[first.count] + first.value;
        if (first.count == 8) {
            const Digits second = digitsAt(at);
            at += second.count;
            fraction += second.count;
            all = all * kWholePowers[second.count] + second.value;
        }
        count += fraction;
    }
    if (count == 0 || count > 15 || *at == '.' || (*at | 0x20) == 'e') return nullptr;
    // Both are exact in a double, so the quotient is the nearest double (Clinger, How to read floating point
    // numbers accurately, 1990). The float nearest to it is also nearest to the number, unless the quotient
    // lies half way between two floats.
    const double exact = static_cast<double>(all) / kPowers[fraction];
    constexpr std::uint64_t kBelowFloat = (std::uint64_t{1} << 29) - 1;
    if ((std::bit_cast<std::uint64_t>(exact) & kBelowFloat) == kBelowFloat / 2 + 1) return nullptr;
    const auto nearest = static_cast<float>(exact);
    value = negative ? -nearest : nearest;
    return at;
}

// A fast reader for the usual OBJ file. It works on several pieces of the file at once, on all processors: a
// file of 70 MB takes 70 ms on two of them, where the line-by-line reader of obj_parser.cpp takes 170 ms.

/// The least number of bytes that are worth a thread.
inline constexpr std::size_t kPlainPiece = std::size_t{1} << 20;

/// Reads a text about which there is nothing to report: complete v, vt and vn lines, faces of three or more
/// corners with positive indices that all exist, `s off` and `s N`, lines without meaning, comments; LF or
/// CR LF; no joined lines. Returns nothing for any other text; parseObj then reads it line by line.
/// `pieceBytes` is about the size of a piece; the result does not depend on it.
std::optional<ObjModel> readPlainObj(std::string_view text, std::size_t pieceBytes = kPlainPiece);

}  // namespace glibra::geometry
