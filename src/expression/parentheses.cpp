#include "expression/parentheses.h"

#include "expression/lexer.h"

namespace glibra::expression {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
/// Bytes at which a word of a classic statement ends.
bool endsWord(char c) {
    return static_cast<unsigned char>(c) <= ' ' ||
           std::string_view("<>[]{}()\"").find(c) != std::string_view::npos;
}

bool isTruth(std::string_view word) {
    while (!word.empty() && (word.back() == ',' || word.back() == ';')) word.remove_suffix(1);
    for (const std::string_view truth : {"true", "false"}) {
        bool same = word.size() == truth.size();
        for (std::size_t i = 0; same && i < word.size(); ++i) same = lower(word[i]) == truth[i];
        if (same) return true;
    }
    return false;
}

/// True for a '-' or '+' that is the sign of the number at its right, or of the exponent of the one around
/// it.
bool isSignOfNumber(std::string_view word, std::size_t at) {
    const auto digitAt = [&](std::size_t i) { return i < word.size() && isDigit(word[i]); };
    if (word[at] != '-' && word[at] != '+') return false;
    if (at == 0 || word[at - 1] == ',' || word[at - 1] == ';')
        return digitAt(at + 1) || (word.substr(at + 1, 1) == "." && digitAt(at + 2));
    const bool afterMark =
        lower(word[at - 1]) == 'e' && at >= 2 && (isDigit(word[at - 2]) || word[at - 2] == '.');
    return afterMark && digitAt(at + 1);
}

bool isPartOfExpression(std::string_view word) {
    const char first = lower(word.front());
    if ((first >= 'a' && first <= 'z') || first == '_') return !isTruth(word);
    for (std::size_t i = 0; i < word.size(); ++i)
        if (std::string_view("+-*/%=!&|").find(word[i]) != std::string_view::npos && !isSignOfNumber(word, i))
            return true;
    return false;
}

}  // namespace

std::size_t partnerOf(std::string_view text, std::size_t open) {
    std::size_t depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        if (text[at] == '#' || text.substr(at, 2) == "//") {
            while (at < text.size() && !isLineEnd(text[at])) ++at;
        } else if (text[at] == '(') {
            ++depth;
        } else if (text[at] == ')' && --depth == 0) {
            return at;
        }
    }
    return std::string_view::npos;
}

bool beginsExpression(std::string_view line, std::size_t open) {
    const std::size_t close = partnerOf(line, open);
    if (close == std::string_view::npos) return false;
    for (std::size_t at = open + 1; at < close; ++at) {
        if (endsWord(line[at])) continue;
        const std::size_t begin = at;
        while (at < close && !endsWord(line[at])) ++at;
        if (isPartOfExpression(line.substr(begin, at - begin))) return true;
    }
    return false;
}

}  // namespace glibra::expression
