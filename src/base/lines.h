#pragma once
// Lines, words and blanks of texts.

#include <algorithm>
#include <string_view>

namespace glibra::base {

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
