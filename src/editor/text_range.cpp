#include "editor/text_range.h"

#include <algorithm>

#include "base/text.h"

namespace glibra::editor {

using base::isOfName;

TextRange wordAt(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    TextRange word{byte, byte};
    while (word.begin > 0 && isOfName(text[word.begin - 1])) --word.begin;
    while (word.end < text.size() && isOfName(text[word.end])) ++word.end;
    return word;
}

std::optional<TextRange> findWord(std::string_view text, std::string_view word, std::size_t begin,
                                  std::size_t end) {
    const auto isOf = [&](std::size_t at) { return at < text.size() && isOfName(text[at]); };
    for (std::size_t at = text.find(word, begin); at < end && !word.empty(); at = text.find(word, at + 1))
        if ((at == 0 || !isOf(at - 1)) && !isOf(at + word.size())) return TextRange{at, at + word.size()};
    return std::nullopt;
}

TextRange nameNear(std::string_view text, std::size_t byte) {
    byte = std::min(byte, text.size());
    for (TextRange word = wordAt(text, byte);; word = wordAt(text, word.begin - 1)) {
        const bool isName = word.begin < word.end && !base::isDigit(text[word.begin]);
        if (isName) return word;
        if (word.begin == 0 || text[word.begin - 1] == '\n' || text[word.begin - 1] == '\r')
            return {byte, byte};
    }
}

TextRange wordBefore(std::string_view text, std::size_t byte) {
    return {wordAt(text, byte).begin, std::min(byte, text.size())};
}

std::string_view lineBefore(std::string_view text, std::size_t byte) {
    const std::size_t begin = byte == 0 ? 0 : text.find_last_of("\r\n", byte - 1) + 1;
    return text.substr(begin, byte - begin);
}

std::string_view statementBefore(std::string_view text, std::size_t byte) {
    std::size_t begin = byte - lineBefore(text, byte).size();
    while (begin >= 2) {
        const std::size_t last = text.find_last_not_of(" \t\r", begin - 2);
        if (last == std::string_view::npos || text[last] != '\\') break;
        begin = last - lineBefore(text, last).size();
    }
    return text.substr(begin, byte - begin);
}

}  // namespace glibra::editor
