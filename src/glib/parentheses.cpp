#include "glib/parentheses.h"

#include <algorithm>

#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr bool isSign(char c) {
    return c == '+' || c == '-';
}

/// Returns the offset after a number and letters that stand directly after it.
std::size_t numberEnd(std::string_view code, std::size_t at) {
    while (at < code.size() && (isOfName(code[at]) || code[at] == '.' ||
                                (isSign(code[at]) && lower(code[at - 1]) == 'e' && at + 1 < code.size() &&
                                 isDigit(code[at + 1]))))
        ++at;
    return at;
}

bool beginsNumber(std::string_view code, std::size_t at) {
    if (at >= code.size()) return false;
    return isDigit(code[at]) || (code[at] == '.' && at + 1 < code.size() && isDigit(code[at + 1]));
}

/// True if the + or - is the sign of a number: a number follows, and nothing stands directly before it.
bool isSignOfNumber(std::string_view code, std::size_t at) {
    constexpr std::string_view kSeparators = " \t\v\f([{<,";
    return beginsNumber(code, at + 1) &&
           (at == 0 || kSeparators.find(code[at - 1]) != std::string_view::npos);
}

}  // namespace

ExpressionFinder::ExpressionFinder(std::string_view code, std::size_t from) : from_(from) {
    look(code);
}

void ExpressionFinder::look(std::string_view code) {
    constexpr std::string_view kOperators = "*/%=!&|";
    std::vector<std::size_t> open;
    std::vector<std::size_t> signs;
    partner_.assign(code.size() - from_, kNone);
    std::size_t at = from_;
    while (at < code.size()) {
        const char c = code[at];
        if (c == '#' || code.substr(at, 2) == "//") {
            at = std::min(code.find_first_of("\r\n", at), code.size());
        } else if (c == '"') {
            const std::size_t close = code.find('"', at + 1);
            at = close == std::string_view::npos ? code.size() : close + 1;
        } else if (isLetter(c) || c == '_') {
            const std::size_t begin = at;
            while (at < code.size() && isOfName(code[at])) ++at;
            const std::string_view word = code.substr(begin, at - begin);
            if (!sameWord(word, "true") && !sameWord(word, "false")) signs.push_back(begin);
        } else if (beginsNumber(code, at)) {
            at = numberEnd(code, at);
        } else {
            if (c == '(') open.push_back(at);
            if (c == ')' && !open.empty()) {
                partner_[open.back() - from_] = at;
                open.pop_back();
            }
            if (kOperators.find(c) != std::string_view::npos || (isSign(c) && !isSignOfNumber(code, at)))
                signs.push_back(at);
            ++at;
        }
    }
    nextSign_.assign(code.size() - from_, kNone);
    std::size_t next = kNone;
    for (std::size_t i = nextSign_.size(); i-- > 0;) {
        if (!signs.empty() && signs.back() == from_ + i) {
            next = signs.back();
            signs.pop_back();
        }
        nextSign_[i] = next;
    }
}

std::size_t ExpressionFinder::endAt(std::size_t open, Parentheses parentheses) const {
    const std::size_t close = partner_[open - from_];
    if (close == kNone || parentheses == Parentheses::brackets) return 0;
    if (parentheses == Parentheses::byContent && nextSign_[open - from_] > close) return 0;
    return close + 1;
}

std::size_t depthOf(std::string_view expression) {
    std::size_t depth = 0;
    std::size_t deepest = 0;
    for (const char c : expression) {
        if (c == '(' || c == '[') deepest = std::max(deepest, ++depth);
        if ((c == ')' || c == ']') && depth > 0) --depth;
    }
    return deepest;
}

}  // namespace glibra::glib
