#include "glib/parse/pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "glib/limits.h"
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

// ---- From tokens to values.

namespace {

class PieceReader {
  public:
    PieceReader(std::span<const Token> tokens, MessageLog& log, bool hasParameters)
        : tokens_(tokens), log_(log), hasParameters_(hasParameters) {}

    std::optional<std::vector<Piece>> read() {
        std::vector<Piece> pieces;
        while (at_ < tokens_.size()) {
            const bool isJoined = at_ > 0 && tokens_[at_ - 1].end == tokens_[at_].begin;
            std::optional<Value> value = tokens_[at_].kind == TokenKind::open ? readGroup() : readSingle();
            if (!value) return std::nullopt;
            pieces.push_back({std::move(*value), isJoined});
        }
        return pieces;
    }

  private:
    std::nullopt_t refuse(const char* id, std::string message, Position position) {
        log_.report(id, std::move(message), position);
        return std::nullopt;
    }

    static Value valueOf(const Token& token, Value::Kind kind) {
        Value value;
        value.kind = kind;
        value.text = token.text;
        value.position = token.position;
        value.begin = token.begin;
        value.end = token.end;
        return value;
    }

    std::optional<Value> readSingle() {
        const Token& token = tokens_[at_++];
        if (++values_ > kMostValues)
            return refuse("glib-E15",
                          fmt::format("more than {} values in a statement", base::groupedText(kMostValues)),
                          token.position);
        switch (token.kind) {
            case TokenKind::number:
                if (isCompleteNumber(token.text)) return readNumberToken(token);
                break;
            case TokenKind::quoted:
                return valueOf(token, Value::Kind::text);
            case TokenKind::expression:
                return readExpression(token);
            case TokenKind::open:
                return refuse(
                    "glib-E20",
                    token.text == "("
                        ? std::string("'(' is not closed on this line")
                        : fmt::format("'{}' inside brackets; brackets cannot be nested, so write a vector as "
                                      "(vec3(1, 0, 0))",
                                      token.text),
                    token.position);
            case TokenKind::close:
                return refuse("glib-E20", fmt::format("'{}' closes nothing", token.text), token.position);
            case TokenKind::word:
                break;
        }
        Value word = valueOf(token, token.truth() ? Value::Kind::truth : Value::Kind::word);
        word.number = token.truth() == true ? 1 : 0;
        return word;
    }

    std::optional<Value> readNumberToken(const Token& token) {
        Value value = valueOf(token, Value::Kind::number);
        value.number = numberPrefix(token.text)->value;
        value.text.clear();
        if (std::isfinite(value.number)) return value;
        return refuse("glib-E31", fmt::format("{} is too large", inQuotes(token.text)), token.position);
    }

    std::optional<Value> readExpression(const Token& token) {
        if (token.text.size() > kLongestExpression)
            return refuse(
                "glib-E15",
                fmt::format("expression of {} bytes; the limit is {}", base::groupedText(token.text.size()),
                            base::groupedText(kLongestExpression)),
                token.position);
        if (const std::size_t depth = depthOf(token.text) + 1; depth > kDeepestParentheses)
            return refuse("glib-E15",
                          fmt::format("parentheses {} deep; the limit is {}", base::groupedText(depth),
                                      kDeepestParentheses),
                          token.position);
        const bool mayBeEmpty = hasParameters_ && at_ == 2 && tokens_.front().end == token.begin;
        if (token.text.find_first_not_of(" \t") == std::string_view::npos && !mayBeEmpty)
            return refuse("glib-E37", "an expression is missing between '(' and ')'", token.position);
        return valueOf(token, Value::Kind::expression);
    }

    std::optional<Value> readGroup() {
        const Token& open = tokens_[at_];
        // A Program statement is cut by the classic rules, by which `(1)` and `(1 0 0)` are brackets.
        if (open.text == "(" && !isNumericBracket()) return readSingle();
        if (open.text == "(" && tokens_[at_ + 2].kind == TokenKind::close) {
            Value number = valueOf(tokens_[at_ + 1], Value::Kind::expression);
            number.position = open.position;
            number.begin = open.begin;
            number.end = tokens_[at_ + 2].end;
            at_ += 3;
            return number;
        }
        ++at_;
        Value group = valueOf(open, open.text == "<"   ? Value::Kind::range
                                    : open.text == "{" ? Value::Kind::color
                                                       : Value::Kind::list);
        group.text.clear();
        while (at_ < tokens_.size() && tokens_[at_].kind != TokenKind::close) {
            std::optional<Value> item = readSingle();
            if (!item) return std::nullopt;
            group.items.push_back(std::move(*item));
        }
        if (at_ == tokens_.size())
            return refuse("glib-E20", fmt::format("'{}' is not closed", open.text), open.position);
        const Token& close = tokens_[at_++];
        if (!bracketsMatch(open.text, close.text))
            return refuse("glib-E20", fmt::format("'{}' closed by '{}'", open.text, close.text),
                          close.position);
        group.end = close.end;
        return checked(std::move(group));
    }

    /// True if numbers and a ')' follow the bracket.
    [[nodiscard]] bool isNumericBracket() const {
        std::size_t at = at_ + 1;
        while (at < tokens_.size() && tokens_[at].kind == TokenKind::number) ++at;
        return at > at_ + 1 && at < tokens_.size() && tokens_[at].kind == TokenKind::close &&
               tokens_[at].text == ")";
    }

    static bool isWord(const Value& value) { return value.kind == Value::Kind::word; }
    /// True for numbers, expressions, and words, which are reported with the statement.
    static bool allNumericOrWords(const Value& group) {
        return std::ranges::all_of(group.items,
                                   [](const Value& each) { return isNumeric(each) || isWord(each); });
    }
    static bool hasComputed(const Value& group) {
        return std::ranges::any_of(group.items, [](const Value& each) {
            return each.kind == Value::Kind::expression || isWord(each);
        });
    }

    std::optional<Value> checked(Value group) {
        for (const Value& each : group.items)
            if (each.kind == Value::Kind::text)
                return refuse("glib-E37", "a text in quotes cannot stand in brackets", each.position);
        if (group.items.empty())
            return refuse("glib-E37", "a value is missing between the brackets", group.position);
        switch (group.kind) {
            case Value::Kind::range:
                return checkedRange(std::move(group));
            case Value::Kind::color:
                return checkedColor(std::move(group));
            default:
                return checkedList(std::move(group));
        }
    }

    std::optional<Value> checkedRange(Value range) {
        if (range.items.size() == 1 && range.items.front().kind == Value::Kind::truth) {
            range.kind = Value::Kind::truth;
            range.number = range.items.front().number;
            range.items.clear();
            return range;
        }
        const bool isChoice = std::ranges::all_of(range.items, isWord);
        // A vector has two to four current values between its limits.
        if (isChoice || (allNumericOrWords(range) && range.items.size() >= 3 && range.items.size() <= 6))
            return range;
        return refuse(
            "glib-E37",
            "< > needs three numbers (min cur max), up to six for a vector (min x y z w max), or words, "
            "or true or false",
            range.position);
    }

    std::optional<Value> checkedColor(Value color) {
        const std::size_t count = color.items.size();
        const bool fits = count == 1 || count == 3 || count == 4 || (hasComputed(color) && count < 3);
        if (fits && allNumericOrWords(color)) return color;
        return refuse("glib-E37", "{ } needs 3 or 4 numbers, or one for all components", color.position);
    }

    /// `[6 of (...)]` becomes a count and one item.
    std::optional<Value> checkedList(Value list) {
        if (list.items.size() < 2 || list.items[1].kind != Value::Kind::word ||
            !sameWord(list.items[1].text, "of"))
            return list;
        if (list.items.size() != 3 || !isNumeric(list.items[0]) || !isNumeric(list.items[2]))
            return refuse("glib-E37", "expected [COUNT of (EXPRESSION)]", list.position);
        list.count = {std::move(list.items[0])};
        list.items = {std::move(list.items[2])};
        return list;
    }

    std::span<const Token> tokens_;
    MessageLog& log_;
    bool hasParameters_;
    std::size_t at_ = 0;
    std::size_t values_ = 0;
};

}  // namespace

std::optional<std::vector<Piece>> readPieces(std::span<const Token> tokens, MessageLog& log,
                                             bool hasParameters) {
    return PieceReader(tokens, log, hasParameters).read();
}

}  // namespace glibra::glib
