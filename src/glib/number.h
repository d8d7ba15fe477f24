#pragma once
// Numbers as scenes write them (language, 1.5): `5`, `5.`, `.2`, `-.25`, `1e-3`, and whatever follows such a
// beginning.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::glib {

/// The number at the beginning of a token.
struct NumberPrefix {
    double value = 0;  ///< correctly rounded; 0 where it underflows, and where it is not finite
    std::size_t length =
        0;  ///< bytes of the token that belong to it; the rest is ignored by the language (glib-W04)
    bool finite = true;  ///< false: too large for a 32-bit float (glib-E05)
};

/// The longest numeric prefix: [+-] digits [. digits] [exponent] or [+-] . digits [exponent]. Nothing for a
/// word; hexadecimal, `inf` and `nan` are words. Independent of the locale.
std::optional<NumberPrefix> numberPrefix(std::string_view token);

/// Bytes of the token that numberPrefix would read; 0 for a word.
std::size_t numberLength(std::string_view token);

/// True if the token is a number from its first byte to its last.
bool isCompleteNumber(std::string_view token);

/// The shortest decimal text that reads back as the same double: "0.1", "3", "1e+30".
std::string numberText(double value);

/// A whole number with commas between thousands, for limits in messages: "8,388,608".
std::string groupedText(long long value);

}  // namespace glibra::glib
