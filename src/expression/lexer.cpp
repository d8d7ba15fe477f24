#include "expression/lexer.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

#include "base/text.h"

namespace glibra::expression {
namespace {

using base::isDigit;

constexpr std::string_view kNoBreakSpace = "\xc2\xa0";

bool isHexDigit(char c) {
    return isDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}
bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\n' || c == '\r';
}

/// Signs of two bytes come first.
constexpr std::string_view kSigns[] = {"<=", ">=", "==", "!=", "&&", "||", "^^", "<<", ">>", "+",
                                       "-",  "*",  "/",  "%",  "<",  ">",  "!",  "~",  "&",  "|",
                                       "^",  "?",  ":",  "(",  ")",  "[",  "]",  ",",  "."};

/// How many bytes from `at` on satisfy the condition.
template <class Condition>
std::size_t countWhile(std::string_view text, std::size_t at, const Condition& condition) {
    std::size_t end = at;
    while (end < text.size() && condition(text[end])) ++end;
    return end - at;
}

/// For a decimal number without sign that no double can hold: true if it is too large, false if it is too
/// small.
bool isAboveOne(std::string_view decimal) {
    constexpr long kFar = 1'000'000;
    const std::size_t mantissa = std::min(decimal.find_first_of("eE"), decimal.size());
    const std::size_t point = std::min(decimal.find('.'), mantissa);
    const std::size_t first = decimal.find_first_of("123456789");
    if (first >= mantissa) return false;
    long exponent = 0;
    if (mantissa < decimal.size()) {
        const bool isNegative = decimal[mantissa + 1] == '-';
        const char* const digits = decimal.data() + mantissa + (decimal[mantissa + 1] == '+' ? 2 : 1);
        if (std::from_chars(digits, decimal.data() + decimal.size(), exponent).ec != std::errc())
            exponent = isNegative ? -kFar : kFar;
    }
    return static_cast<long>(point) - static_cast<long>(first) + exponent > 0;
}

}  // namespace

Token Lexer::token(TokenKind kind, std::size_t length) const {
    Token token;
    token.kind = kind;
    token.text = text_.substr(at_, length);
    token.range = {static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + token.text.size())};
    return token;
}

Token Lexer::wrong(std::size_t length, const char* why) const {
    Token wrong = token(TokenKind::wrong, length);
    wrong.why = why;
    return wrong;
}

void Lexer::skipBlanks() {
    while (at_ < text_.size()) {
        const std::string_view rest = text_.substr(at_);
        if (isBlank(rest[0])) {
            ++at_;
        } else if (rest.starts_with(kNoBreakSpace)) {
            at_ += kNoBreakSpace.size();
        } else if (rest[0] == '#' || rest.starts_with("//")) {
            at_ += countWhile(rest, 0, [](char c) { return c != '\n' && c != '\r'; });
        } else if (rest[0] == '\\') {
            // Joins two lines if only blanks and a comment follow it.
            const std::size_t next = 1 + countWhile(rest, 1, [](char c) { return c == ' ' || c == '\t'; });
            const std::string_view after = rest.substr(next);
            if (!after.starts_with('\n') && !after.starts_with('\r') && !after.starts_with('#') &&
                !after.starts_with("//"))
                return;
            at_ += next;
        } else {
            return;
        }
    }
}

Token Lexer::number() {
    const std::string_view rest = text_.substr(at_);
    const bool isHex =
        rest.size() > 2 && rest[0] == '0' && (rest[1] == 'x' || rest[1] == 'X') && isHexDigit(rest[2]);
    std::size_t end = 0;
    double value = 0;
    if (isHex) {
        end = 2 + countWhile(rest, 2, isHexDigit);
        std::uint64_t whole = 0;
        const auto read = std::from_chars(rest.data() + 2, rest.data() + end, whole, 16);
        if (read.ec != std::errc() || whole > (std::uint64_t{1} << 53U))
            return wrong(end, "a hexadecimal number is at most 2^53");
        value = static_cast<double>(whole);
    } else {
        end = countWhile(rest, 0, isDigit);
        if (end < rest.size() && rest[end] == '.') end += 1 + countWhile(rest, end + 1, isDigit);
        if (end < rest.size() && (rest[end] == 'e' || rest[end] == 'E')) {
            const std::size_t digits =
                end + (end + 1 < rest.size() && (rest[end + 1] == '+' || rest[end + 1] == '-') ? 2 : 1);
            const std::size_t count = countWhile(rest, digits, isDigit);
            if (count > 0) end = digits + count;
        }
        const auto read = std::from_chars(rest.data(), rest.data() + end, value);
        if (read.ec == std::errc::result_out_of_range) {
            if (isAboveOne(rest.substr(0, end))) return wrong(end, "the number is too large");
            value = 0;
        }
    }
    // Suffixes of GLSL mean nothing here.
    std::size_t suffix = 0;
    for (const std::string_view each : {"lf", "LF", "f", "F", "u", "U"})
        if (suffix == 0 && rest.substr(end).starts_with(each)) suffix = each.size();
    const std::size_t more = countWhile(rest, end + suffix, base::isOfName);
    if (more > 0) return wrong(end + suffix + more, "this is neither a number nor a name");
    Token number = token(TokenKind::number, end + suffix);
    number.number = value;
    return number;
}

Token Lexer::next() {
    skipBlanks();
    if (at_ >= text_.size()) return token(TokenKind::end, 0);
    const std::string_view rest = text_.substr(at_);
    Token result;
    if (isDigit(rest[0]) || (rest.size() > 1 && rest[0] == '.' && isDigit(rest[1]))) {
        result = number();
    } else if (base::beginsName(rest[0])) {
        result = token(TokenKind::name, countWhile(rest, 0, base::isOfName));
    } else {
        for (const std::string_view sign : kSigns)
            if (result.kind == TokenKind::end && rest.starts_with(sign))
                result = token(TokenKind::sign, sign.size());
        if (result.kind == TokenKind::end) {
            // A character of UTF-8 is shown whole.
            const std::size_t length = 1 + countWhile(rest, 1, [](char c) {
                                           return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
                                       });
            result = wrong(rest[0] == '=' ? 1 : length,
                           rest[0] == '=' ? "nothing can be assigned here; '==' compares"
                                          : "this character is not part of the syntax of expressions");
        }
    }
    at_ += result.text.size();
    return result;
}

}  // namespace glibra::expression
