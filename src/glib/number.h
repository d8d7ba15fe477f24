#pragma once
// Numbers as scenes write them (language, 1.5): `5`, `5.`, `.2`, `-.25`, `1e-3`, with or without further text
// after them.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::glib {

/// The number at the beginning of a token.
struct NumberPrefix {
    double value = 0;        ///< correctly rounded; 0 if it underflows, infinite beyond all doubles
    std::size_t length = 0;  ///< how many bytes of the token belong to it; the rest is ignored (glib-W04)
    bool finite = true;      ///< false: too large for a 32-bit float (glib-E31)
};

/// Returns the longest numeric prefix: [+-] digits [. digits] [exponent] or [+-] . digits [exponent]; nothing
/// for a word. Hexadecimal numbers, `inf` and `nan` are words. Does not depend on the locale.
std::optional<NumberPrefix> numberPrefix(std::string_view token);

/// Returns how many bytes of the token numberPrefix would read; 0 for a word.
std::size_t numberLength(std::string_view token);

/// True if the token is a number from its first byte to its last.
bool isCompleteNumber(std::string_view token);

/// Returns the shortest decimal text that reads back as the same double: "0.1", "3", "1e+30".
std::string numberText(double value);

}  // namespace glibra::glib
