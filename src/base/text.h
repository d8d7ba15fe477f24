#pragma once
// Small operations on text.

#include <glibra/diagnostic.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

namespace glibra::base {

// Letters, words and counts in texts: ASCII only, in any locale.

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

// Fields of tables as text.

/// A field of a CSV file (RFC 4180), quoted if it has one of `special`.
inline std::string csvField(std::string_view text, std::string_view special = ",\"\r\n") {
    if (text.find_first_of(special) == std::string_view::npos) return std::string(text);
    std::string field = "\"";
    for (const char each : text) field.append(each == '"' ? 2 : 1, each);
    return field + '"';
}

// Texts as words of a command line.

/// In single quotes of a POSIX shell.
inline std::string shellQuoted(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

/// As one word of a POSIX shell; quoted only where it has to be: if it has other characters than letters,
/// digits and those of `plain`.
inline std::string shellWord(std::string_view text, std::string_view plain = "_-+=./,:@%") {
    const auto isPlain = [&](char c) { return isLetter(c) || isDigit(c) || plain.find(c) != plain.npos; };
    const bool needsNone = !text.empty() && std::all_of(text.begin(), text.end(), isPlain);
    return needsNone ? std::string(text) : shellQuoted(text);
}

// Makes text of unknown origin (messages, names, scenes) valid for XML and HTML.

/// For XML 1.0 and HTML, in element content and in attributes with double quotes. The characters & < > " '
/// are escaped. What XML cannot contain (most control characters, U+FFFE, U+FFFF, bytes that are not UTF-8)
/// becomes U+FFFD.
std::string escapeXml(std::string_view text);

/// "2.1 GiB", "300 MiB", "4096 bytes": rounded up to tenths from 1 MiB on, so that a size just above a limit
/// is not displayed as the limit.
std::string readableBytes(std::uint64_t bytes);

/// What an exception means, for a message: "out of memory (--memory)", or its text without the names that a
/// library gives its exceptions.
std::string reasonOf(const std::exception& problem);

// Lines, words and blanks of texts.

/// The place of a byte that a parser of the text counts from 1.
Place placeOfByte(std::string_view text, std::size_t byte, const std::string& file);

/// The text without blanks at either end.
constexpr std::string_view trimmed(std::string_view text, std::string_view blanks = " \t") {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Takes the first word from the text, with the blanks before it. Empty if there is none.
constexpr std::string_view nextWord(std::string_view& text, std::string_view blanks = " \t") {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

/// Takes the first line from the text. Returns it without its line end, LF or CR LF.
constexpr std::string_view nextLine(std::string_view& text) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

}  // namespace glibra::base
