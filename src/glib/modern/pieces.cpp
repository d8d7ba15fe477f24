#include "glib/modern/pieces.h"

#include <algorithm>

#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

/// Adds the parts of a text with points between them.
void addParts(std::string_view text, std::vector<NamePart>& path) {
    if (text.starts_with('.')) text.remove_prefix(1);
    while (true) {
        const std::size_t point = text.find('.');
        path.push_back({std::string(text.substr(0, point)), {}});
        if (point == std::string_view::npos) return;
        text.remove_prefix(point + 1);
    }
}

}  // namespace

bool isUnquoted(const Value& value) {
    return (value.kind == Value::Kind::word || value.kind == Value::Kind::truth) && !value.text.empty();
}

bool looksLikeExpression(std::string_view word) {
    const auto countOf = [&](char bracket) { return std::ranges::count(word, bracket); };
    if (isCompleteNumber(word) || countOf(')') > countOf('(')) return false;
    const std::size_t at = word.find_first_of("*/%+-");
    return at != std::string_view::npos && at + 1 < word.size() &&
           (isOfName(word[at + 1]) || word[at + 1] == '.' || word[at + 1] == '-' || word[at + 1] == '(') &&
           std::ranges::any_of(word, isOfName);
}

std::string_view expressionAt(std::string_view text, std::span<const Token> tokens, const Token& first) {
    std::size_t end = first.end;
    for (const Token* next = &first + 1; next < tokens.data() + tokens.size(); ++next) {
        const std::string_view soFar = text.substr(first.begin, end - first.begin);
        const bool isOpen = std::ranges::count(soFar, '(') > std::ranges::count(soFar, ')');
        if (next->begin != end && !isOpen) break;
        end = next->end;
    }
    return text.substr(first.begin, end - first.begin);
}

bool isDotted(std::string_view text, bool hasHead) {
    if (hasHead) {
        if (!text.starts_with('.')) return false;
        text.remove_prefix(1);
    }
    while (true) {
        const std::size_t point = text.find('.');
        if (!isIdentifier(text.substr(0, point))) return false;
        if (point == std::string_view::npos) return true;
        text.remove_prefix(point + 1);
    }
}

std::string_view beforePoint(std::string_view text) {
    return text.substr(0, text.find('.'));
}
std::string_view afterPoint(std::string_view text) {
    const std::size_t point = text.find('.');
    return point == std::string_view::npos ? std::string_view() : text.substr(point + 1);
}

bool Pieces::isSubscript(std::size_t at) const {
    if (!isJoined(at)) return false;
    const Value& value = (*this)[at];
    if (value.kind == Value::Kind::expression) return true;
    return value.kind == Value::Kind::list && value.count.empty() &&
           source(value).find_first_of("\r\n") == std::string_view::npos;
}

std::size_t Pieces::objectEnd(std::size_t at) const {
    const Value* value = find(at);
    if (value == nullptr || value->kind != Value::Kind::word || !isDotted(value->text, false)) return at;
    for (std::size_t next = at + 1;;) {
        if (isSubscript(next))
            ++next;
        else if (isJoined(next) && (*this)[next].kind == Value::Kind::word &&
                 isDotted((*this)[next].text, true))
            ++next;
        else
            return next;
    }
}

std::size_t Pieces::tagEnd(std::size_t at) const {
    const Value* value = find(at);
    if (value == nullptr || !isUnquoted(*value) || !isDotted(value->text, false)) return at;
    std::size_t next = at + 1;
    while (isSubscript(next) && (*this)[next].kind == Value::Kind::list && valueFollows(next + 1)) {
        ++next;
        if (isJoined(next) && (*this)[next].kind == Value::Kind::word) ++next;
    }
    return next;
}

bool Pieces::valueFollows(std::size_t at) const {
    const Value* value = find(at);
    if (value == nullptr) return false;
    if (value->kind != Value::Kind::word) return true;
    if (isJoined(at) && isDotted(value->text, true)) return true;
    // A word is a value if what follows it is not: `uTex[2] shadow uB 5`, but `uA[3] uB 5`.
    const std::size_t next = objectEnd(at);
    if (next == at) return false;
    return next == size() || (*this)[next].kind == Value::Kind::word;
}

std::string_view Pieces::source(const Value& value) const {
    return text_.substr(value.begin, value.end - value.begin);
}

std::string Pieces::written(std::size_t begin, std::size_t end) const {
    return std::string(text_.substr((*this)[begin].begin, (*this)[end - 1].end - (*this)[begin].begin));
}

std::string Pieces::onOneLine(std::size_t begin, std::size_t end) const {
    constexpr std::string_view kLineEnds = "\r\n", kBetween = " \t\r\n\\";
    const std::string all = written(begin, end);
    std::string line;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t next = std::min(all.find_first_not_of(kBetween, at), all.size());
        const std::string_view space = std::string_view(all).substr(at, next - at);
        if (space.find_first_of(kLineEnds) != std::string_view::npos)
            line += ' ';
        else
            line += space;
        at = std::min(all.find_first_of(kBetween, next), all.size());
        line += std::string_view(all).substr(next, at - next);
    }
    return line;
}

std::string Pieces::expressionFrom(std::size_t at) const {
    std::size_t end = at + 1;
    while (end < size()) {
        const std::string whole = written(at, end);
        const bool isOpen = std::ranges::count(whole, '(') > std::ranges::count(whole, ')');
        if (!isJoined(end) && !isOpen) break;
        ++end;
    }
    return onOneLine(at, end);
}

Value Pieces::indexOf(const Value& subscript) const {
    Value index = subscript;
    if (subscript.kind == Value::Kind::expression) return index;
    if (subscript.items.size() == 1 && isNumeric(subscript.items.front())) return subscript.items.front();
    index.kind = Value::Kind::expression;
    index.items.clear();
    const std::string_view all = source(subscript);
    index.text = all.substr(1, all.size() - 2);
    return index;
}

std::vector<NamePart> Pieces::pathOf(std::size_t begin, std::size_t end) const {
    std::vector<NamePart> path;
    for (std::size_t i = begin; i < end; ++i) {
        const Value& value = (*this)[i];
        if (value.kind == Value::Kind::word || value.kind == Value::Kind::truth)
            addParts(value.text, path);
        else
            path.back().index = {indexOf(value)};
    }
    return path;
}

Value Pieces::nameOf(std::size_t begin, std::size_t end) const {
    Value name = (*this)[begin];
    name.kind = Value::Kind::word;
    name.text = written(begin, end);
    name.end = (*this)[end - 1].end;
    name.path = pathOf(begin, end);
    return name;
}

}  // namespace glibra::glib
