#pragma once
// Letters, words and counts in texts: ASCII only, in any locale.

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace glibra::base {

constexpr char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

constexpr bool isLetter(char c) {
    return lower(c) >= 'a' && lower(c) <= 'z';
}

constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// True for the characters that a name of GLIB, of GLSL or of C may begin with, and may have further on.
constexpr bool beginsName(char c) {
    return isLetter(c) || c == '_';
}
constexpr bool isOfName(char c) {
    return beginsName(c) || isDigit(c);
}

/// True if the words are equal, ignoring the case of ASCII letters.
constexpr bool sameWord(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i])) return false;
    return true;
}

inline std::string lower(std::string_view word) {
    std::string text(word);
    for (char& c : text) c = lower(c);
    return text;
}

/// Returns the text in single quotes for a message. A long text is cut, between characters of UTF-8.
inline std::string inQuotes(std::string_view text) {
    constexpr std::size_t kShown = 60;
    std::size_t end = text.size();
    if (end > kShown) {
        end = kShown;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;
    }
    std::string result = "'";
    result.append(text.substr(0, end)).append(end < text.size() ? "...'" : "'");
    return result;
}

/// Returns a whole number with commas between thousands: "8,388,608".
std::string groupedText(std::integral auto number) {
    std::string text = std::to_string(number);
    const std::size_t first = text.front() == '-' ? 1 : 0;
    for (std::size_t at = text.size(); at > first + 3;) text.insert(at -= 3, 1, ',');
    return text;
}

namespace detail {
inline std::string withNoun(std::string number, std::string_view one, std::string_view several) {
    const bool isOne = number == "1";
    number.append(" ").append(isOne || several.empty() ? one : several);
    return !isOne && several.empty() ? number + "s" : number;
}
}  // namespace detail

/// Returns "1 byte", "4096 bytes"; with `several`, "1 vertex", "2 vertices".
std::string counted(std::integral auto count, std::string_view one, std::string_view several = {}) {
    return detail::withNoun(std::to_string(count), one, several);
}

/// The same with commas between thousands: "4,096 bytes".
std::string countedInGroups(std::integral auto count, std::string_view one, std::string_view several = {}) {
    return detail::withNoun(groupedText(count), one, several);
}

}  // namespace glibra::base
