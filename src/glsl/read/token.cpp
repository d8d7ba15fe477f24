#include "glsl/read/token.h"

#include <array>

namespace glibra::glsl {
namespace {

constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
constexpr bool isWordStart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr std::array<std::string_view, 23> kLongPunctuators = {
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^", "+=",
    "-=",  "*=",  "/=", "%=", "&=", "^=", "|=", "<<", ">>", "##", "->"};
constexpr std::string_view kShortPunctuators = "+-*/%<>=!&|^~?:;,.()[]{}#";

/// Walks the text, whose positions are in bytes.
class Lexer {
  public:
    Lexer(std::string_view text, std::deque<std::string>& storage) : text_(text), storage_(storage) {}

    std::vector<Token> run() {
        tokens_.reserve(text_.size() / 3 + 16);
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

  private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[nodiscard]] bool joinsHere() const { return peek() == '\\' && peek(1) == '\n'; }

    void push(TokenKind kind, std::string_view text, std::size_t length) {
        Token token;
        token.text = text;
        token.line = line_;
        token.column = static_cast<std::int32_t>(at_ - lineStart_) + 1;
        token.kind = kind;
        tokens_.push_back(token);
        at_ += length;
    }
    void push(TokenKind kind, std::size_t length) { push(kind, text_.substr(at_, length), length); }
    void endLine() {
        ++line_;
        lineStart_ = at_;
    }

    void step() {
        const char c = peek();
        if (c == '\n') {
            push(TokenKind::newline, 1);
            endLine();
        } else if (joinsHere()) {
            push(TokenKind::splice, 2);
            endLine();
        } else if (isBlank(c)) {
            std::size_t length = 1;
            while (isBlank(peek(length))) ++length;
            push(TokenKind::blank, length);
        } else if (c == '/' && peek(1) == '/') {
            lineComment();
        } else if (c == '/' && peek(1) == '*') {
            blockComment();
        } else if (isWordStart(c)) {
            joined(TokenKind::word);
        } else if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
            joined(TokenKind::number);
        } else {
            punctuator();
        }
    }

    void lineComment() {
        std::size_t end = text_.find('\n', at_);
        if (end == std::string_view::npos) end = text_.size();
        const bool backslash = text_[end - 1] == '\\';
        push(TokenKind::comment, text_.substr(at_, end - at_ - (backslash ? 1 : 0)), end - at_);
        tokens_.back().droppedBackslash = backslash;
    }

    void blockComment() {
        std::size_t end = text_.find("*/", at_ + 2);
        end = end == std::string_view::npos ? text_.size() : end + 2;
        const std::size_t start = at_;
        push(TokenKind::comment, end - at_);
        for (std::size_t i = start; i < end; ++i)
            if (text_[i] == '\n') {
                ++line_;
                lineStart_ = i + 1;
            }
    }

    /// The number of characters from `from` on that belong to a word or number; `previous` is the character
    /// before them.
    [[nodiscard]] std::size_t run(TokenKind kind, std::size_t from, char previous) const {
        std::size_t i = from;
        for (; i < text_.size(); ++i) {
            const char c = text_[i];
            const bool sign = kind == TokenKind::number && (c == '+' || c == '-') &&
                              (previous == 'e' || previous == 'E') && !hexadecimal();
            if (!isWordPart(c) && !(kind == TokenKind::number && c == '.') && !sign) break;
            previous = c;
        }
        return i - from;
    }
    [[nodiscard]] bool hexadecimal() const { return peek() == '0' && (peek(1) == 'x' || peek(1) == 'X'); }

    void joined(TokenKind kind) {
        const std::size_t length = run(kind, at_, '\0');
        std::size_t next = at_ + length;
        if (!(text_.substr(next, 2) == "\\\n" && next + 2 < text_.size() && isWordPart(text_[next + 2]))) {
            push(kind, length);
            return;
        }
        std::string whole(text_.substr(at_, length));
        std::size_t splices = 0;
        while (text_.substr(next, 2) == "\\\n" && next + 2 < text_.size() && isWordPart(text_[next + 2])) {
            const std::size_t more = run(kind, next + 2, whole.back());
            whole += text_.substr(next + 2, more);
            next += 2 + more;
            ++splices;
        }
        storage_.push_back(std::move(whole));
        push(kind, storage_.back(), next - at_);
        // The line ends inside the word come after it, so that line numbers stay right.
        for (; splices > 0; --splices) {
            push(TokenKind::splice, "\\\n", 0);
            endLine();
        }
    }

    void punctuator() {
        const std::string_view rest = text_.substr(at_);
        for (const std::string_view each : kLongPunctuators)
            if (rest.starts_with(each)) return push(TokenKind::punctuator, each.size());
        const bool known = kShortPunctuators.find(rest.front()) != std::string_view::npos;
        push(known ? TokenKind::punctuator : TokenKind::other, 1);
    }

    std::string_view text_;
    std::deque<std::string>& storage_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::size_t lineStart_ = 0;
    std::int32_t line_ = 1;
};

}  // namespace

std::string normalizeLines(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::string result;
    result.reserve(text.size() + 1);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\r') {
            result += '\n';
            if (i + 1 < text.size() && text[i + 1] == '\n') ++i;
        } else {
            // A NUL would end the source for some drivers.
            result += c == '\0' ? ' ' : c;
        }
    }
    return result;
}

std::vector<Token> lex(std::string_view text, std::deque<std::string>& storage) {
    return Lexer(text, storage).run();
}

}  // namespace glibra::glsl
