#include "geometry/obj/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace glibra::geometry {

bool TextScanner::number(float& value) {
    const char* digits = at_;
    if (digits != end_ && (*digits == '+' || *digits == '-')) ++digits;
    // from_chars also accepts "inf" and "nan", but no plus sign.
    const bool begins =
        digits != end_ && (isDigit(*digits) || (*digits == '.' && digits + 1 != end_ && isDigit(digits[1])));
    if (!begins) return false;
    const char* const start = *at_ == '+' ? digits : at_;
    float result = 0;
    const auto [rest, failure] = std::from_chars(start, end_, result);
    if (failure == std::errc::result_out_of_range) {
        // Too large or too small: as a double it is clear which; beyond a double's range the sign of the
        // exponent decides.
        double wide = 0;
        const bool isWide = std::from_chars(start, rest, wide).ec == std::errc{};
        const char* const exponent = std::find_if(start, rest, [](char c) { return c == 'e' || c == 'E'; });
        const bool isTiny = isWide ? std::abs(wide) < 1
                                   : (exponent != rest && exponent + 1 != rest && exponent[1] == '-') ||
                                         *digits == '0' || *digits == '.';
        if (!isTiny) return false;
        result = static_cast<float>(wide);
    } else if (failure != std::errc{}) {
        return false;
    }
    value = result;
    at_ = rest;
    return true;
}

bool TextScanner::integer(long long& value) {
    const char* at = at_;
    const bool negative = at != end_ && *at == '-';
    if (at != end_ && (*at == '+' || *at == '-')) ++at;
    if (at == end_ || !isDigit(*at)) return false;
    constexpr long long kLargest = 9'000'000'000'000'000'000;
    long long result = 0;
    for (; at != end_ && isDigit(*at); ++at)
        result = result > kLargest / 10 - 1 ? kLargest : result * 10 + (*at - '0');
    value = negative ? -result : result;
    at_ = at;
    return true;
}

void TextScanner::nextLine() {
    bool inComment = false;
    for (; at_ != end_; ++at_) {
        if (*at_ == '#') inComment = true;
        if (*at_ == '\\' && !inComment) {
            if (const std::size_t length = joinLength(at_); length > 0) {
                skipJoin();
                --at_;
                continue;
            }
        }
        if (isLineEnd(*at_)) {
            if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
            ++at_;
            ++line_;
            lineStart_ = at_;
            return;
        }
    }
}

std::size_t TextScanner::joinLength(const char* at) const {
    const char* next = at + 1;
    while (next != end_ && isBlank(*next)) ++next;
    if (next == end_) return static_cast<std::size_t>(next - at);
    if (!isLineEnd(*next)) return 0;
    if (*next == '\r' && next + 1 != end_ && next[1] == '\n') ++next;
    return static_cast<std::size_t>(next + 1 - at);
}

bool TextScanner::skipJoin() {
    const std::size_t length = joinLength(at_);
    if (length == 0) return false;
    const bool hasLineEnd = isLineEnd(at_[length - 1]);
    at_ += length;
    if (hasLineEnd) {
        ++line_;
        lineStart_ = at_;
    }
    return true;
}

}  // namespace glibra::geometry
