#include "glib/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

bool isHexDigit(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

/// Returns the number of digits in `text` from `at` on.
std::size_t digitsAt(std::string_view text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && isDigit(text[end])) ++end;
    return end - at;
}

/// For a decimal text that no double can hold, returns true if it is too large, false if it is too small.
bool isHuge(std::string_view digits) {
    long long magnitude = 0;  // decimal places between the first digit that is not 0 and the point
    bool pointSeen = false;
    bool digitSeen = false;
    std::size_t i = 0;
    for (; i < digits.size() && digits[i] != 'e' && digits[i] != 'E'; ++i) {
        if (digits[i] == '.') {
            pointSeen = true;
        } else if (isDigit(digits[i])) {
            digitSeen = digitSeen || digits[i] != '0';
            if (digitSeen && !pointSeen) ++magnitude;
            if (!digitSeen && pointSeen) --magnitude;
        }
    }
    if (i >= digits.size()) return magnitude > 0;
    constexpr long long kBeyondAnyText = 1'000'000'000'000;
    const bool negative = digits[++i] == '-';
    long long exponent = 0;
    for (; i < digits.size(); ++i)
        if (isDigit(digits[i])) exponent = std::min(kBeyondAnyText, exponent * 10 + (digits[i] - '0'));
    return magnitude + (negative ? -exponent : exponent) > 0;
}

}  // namespace

std::size_t numberLength(std::string_view token) {
    const std::size_t first = !token.empty() && (token[0] == '+' || token[0] == '-') ? 1 : 0;
    std::size_t end = first + digitsAt(token, first);
    if (end > first) {
        const bool hex = end == first + 1 && token[first] == '0' && end + 1 < token.size() &&
                         (token[end] == 'x' || token[end] == 'X') && isHexDigit(token[end + 1]);
        if (hex) return 0;
        if (end < token.size() && token[end] == '.') end += 1 + digitsAt(token, end + 1);
    } else {
        if (first >= token.size() || token[first] != '.') return 0;
        const std::size_t digits = digitsAt(token, first + 1);
        if (digits == 0) return 0;
        end = first + 1 + digits;
    }
    if (end < token.size() && (token[end] == 'e' || token[end] == 'E')) {
        std::size_t exponent = end + 1;
        if (exponent < token.size() && (token[exponent] == '+' || token[exponent] == '-')) ++exponent;
        const std::size_t digits = digitsAt(token, exponent);
        if (digits > 0) end = exponent + digits;
    }
    return end;
}

std::optional<NumberPrefix> numberPrefix(std::string_view token) {
    const std::size_t end = numberLength(token);
    if (end == 0) return std::nullopt;
    const std::size_t first = token[0] == '+' || token[0] == '-' ? 1 : 0;
    NumberPrefix number;
    number.length = end;
    const std::string_view unsignedText = token.substr(first, end - first);  // from_chars rejects '+'
    const auto [rest, problem] =
        std::from_chars(unsignedText.data(), unsignedText.data() + unsignedText.size(), number.value);
    if (problem == std::errc::result_out_of_range) {
        number.value = isHuge(unsignedText) ? std::numeric_limits<double>::infinity() : 0;
    }
    number.finite = std::isfinite(base::toFloat(number.value));
    if (token[0] == '-') number.value = -number.value;
    return number;
}

bool isCompleteNumber(std::string_view token) {
    return !token.empty() && numberLength(token) == token.size();
}

std::string numberText(double value) {
    std::array<char, 32> text{};  // the longest shortest form, -2.2250738585072014e-308, has 24 bytes
    const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc() ? std::string(text.data(), end) : std::string("?");
}

}  // namespace glibra::glib
