#include "editor/text_lines.h"

#include <algorithm>

#include "base/utf8.h"

namespace glibra::editor {
namespace {

std::size_t unitsOf(const base::Character& character) {
    constexpr std::uint32_t kFirstPair = 0x10000;
    return character.code >= kFirstPair ? 2 : 1;
}

}  // namespace

TextLines::TextLines(std::string_view text) : text_(text), begins_{0} {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n")) begins_.push_back(i + 1);
}

TextRange TextLines::line(std::size_t index) const {
    if (index >= begins_.size()) return {text_.size(), text_.size()};
    const std::size_t begin = begins_[index];
    return {begin, std::min(text_.find_first_of("\r\n", begin), text_.size())};
}

TextPosition TextLines::position(std::size_t byte) const {
    byte = std::min(byte, text_.size());
    const auto after = std::ranges::upper_bound(begins_, byte);
    TextPosition found{static_cast<std::size_t>(after - begins_.begin()) - 1, 0};
    for (std::size_t at = *(after - 1); at < byte;) {
        const base::Character character = base::firstCharacter(text_.substr(at));
        at += character.bytes;
        found.unit += unitsOf(character);
    }
    return found;
}

std::size_t TextLines::byte(TextPosition position) const {
    const TextRange range = line(position.line);
    std::size_t at = range.begin;
    for (std::size_t unit = 0; at < range.end && unit < position.unit;) {
        const base::Character character = base::firstCharacter(text_.substr(at));
        unit += unitsOf(character);
        if (unit > position.unit) break;  // inside of a character
        at += character.bytes;
    }
    return at;
}

}  // namespace glibra::editor
