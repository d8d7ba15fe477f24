#include "glsl/read/token.h"

#include <algorithm>
#include <array>
#include <span>

namespace glibra::glsl {
namespace {

constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

constexpr std::array<std::string_view, 23> kLongPunctuators = {
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^", "+=",
    "-=",  "*=",  "/=", "%=", "&=", "^=", "|=", "<<", ">>", "##", "->"};
constexpr std::string_view kShortPunctuators = "+-*/%<>=!&|^~?:;,.()[]{}#";

/// The text without the backslashes that join lines.
struct JoinedText {
    std::string text;
    std::vector<std::size_t> joints;  ///< positions in `text` where lines were joined
};

/// The end of the comment that begins at `at`, without the line end of a // comment.
std::size_t endOfComment(std::string_view text, std::size_t at) {
    const bool isLine = text[at + 1] == '/';
    const std::size_t end = text.find(isLine ? "\n" : "*/", at + 2);
    if (end == std::string_view::npos) return text.size();
    return isLine ? end : end + 2;
}

JoinedText joinLines(std::string_view text, bool joinsComments) {
    JoinedText joined;
    std::string& to = joined.text;
    to.reserve(text.size());
    enum class In { code, lineComment, blockComment } in = In::code;
    std::size_t codeSince = 0;  // a comment begins with two characters of code
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isJoint = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '\n';
        if (isJoint && (in != In::lineComment || joinsComments)) {
            joined.joints.push_back(to.size());
            ++i;
            continue;
        }
        to += text[i];
        if (in == In::lineComment && text[i] == '\n') {
            in = In::code;
            codeSince = to.size();
        } else if (to.size() < codeSince + 2) {
            continue;
        } else if (in == In::blockComment && to.ends_with("*/")) {
            in = In::code;
            codeSince = to.size();
        } else if (in == In::code && (to.ends_with("//") || to.ends_with("/*"))) {
            in = to.back() == '/' ? In::lineComment : In::blockComment;
            codeSince = to.size();
        }
    }
    return joined;
}

/// Walks the text, whose positions are in bytes. `joints` are the places where lines were joined.
class Lexer {
  public:
    Lexer(std::string_view text, std::span<const std::size_t> joints) : text_(text), joints_(joints) {}

    std::vector<Token> run() {
        tokens_.reserve(text_.size() / 3 + 16);
        while (at_ < text_.size()) step();
        takeJoints();
        return std::move(tokens_);
    }

  private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void push(TokenKind kind, std::size_t length) {
        Token token;
        token.text = text_.substr(at_, length);
        token.line = line_;
        token.column = static_cast<std::int32_t>(at_ - lineStart_) + 1;
        token.kind = kind;
        tokens_.push_back(token);
        at_ += length;
    }

    /// The joints up to here come after what they interrupt, so that line numbers stay right.
    void takeJoints() {
        for (; joint_ < joints_.size() && joints_[joint_] <= at_; ++joint_) {
            Token token;
            token.text = "\\\n";
            token.line = line_;
            token.column =
                static_cast<std::int32_t>(joints_[joint_] - std::min(lineStart_, joints_[joint_])) + 1;
            token.kind = TokenKind::splice;
            tokens_.push_back(token);
            ++line_;
            lineStart_ = std::max(lineStart_, joints_[joint_]);
        }
    }

    void step() {
        takeJoints();
        const char c = peek();
        if (c == '\n') {
            push(TokenKind::newline, 1);
            ++line_;
            lineStart_ = at_;
        } else if (isBlank(c)) {
            std::size_t length = 1;
            while (isBlank(peek(length))) ++length;
            push(TokenKind::blank, length);
        } else if (c == '/' && peek(1) == '/') {
            lineComment();
        } else if (c == '/' && peek(1) == '*') {
            blockComment();
        } else if (base::beginsName(c)) {
            push(TokenKind::word, lengthOf(TokenKind::word));
        } else if (base::isDigit(c) || (c == '.' && base::isDigit(peek(1)))) {
            push(TokenKind::number, lengthOf(TokenKind::number));
        } else {
            punctuator();
        }
    }

    void lineComment() {
        const std::size_t end = endOfComment(text_, at_);
        const bool backslash = text_[end - 1] == '\\';
        const auto joint = std::ranges::lower_bound(joints_, at_ + 2);
        const bool isContinued = joint != joints_.end() && *joint < end;
        push(TokenKind::comment, end - at_);
        tokens_.back().continuedComment = isContinued;
        if (!backslash) return;
        tokens_.back().text.remove_suffix(1);
        tokens_.back().droppedBackslash = true;
    }

    void blockComment() {
        const std::size_t start = at_;
        push(TokenKind::comment, endOfComment(text_, at_) - at_);
        for (std::size_t i = start; i < at_; ++i)
            if (text_[i] == '\n') {
                ++line_;
                lineStart_ = i + 1;
            }
    }

    /// The number of characters from here on that belong to a word or number.
    [[nodiscard]] std::size_t lengthOf(TokenKind kind) const {
        const bool hexadecimal = peek() == '0' && (peek(1) == 'x' || peek(1) == 'X');
        std::size_t i = at_;
        for (; i < text_.size(); ++i) {
            const char c = text_[i];
            const bool sign = kind == TokenKind::number && (c == '+' || c == '-') && i > at_ &&
                              (text_[i - 1] == 'e' || text_[i - 1] == 'E') && !hexadecimal;
            if (!base::isOfName(c) && !(kind == TokenKind::number && c == '.') && !sign) break;
        }
        return i - at_;
    }

    void punctuator() {
        const std::string_view rest = text_.substr(at_);
        for (const std::string_view each : kLongPunctuators)
            if (rest.starts_with(each)) return push(TokenKind::punctuator, each.size());
        const bool known = kShortPunctuators.find(rest.front()) != std::string_view::npos;
        push(known ? TokenKind::punctuator : TokenKind::other, 1);
    }

    std::string_view text_;
    std::span<const std::size_t> joints_;
    std::vector<Token> tokens_;
    std::size_t joint_ = 0;
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
        if (c == '\r' || c == '\n') {
            // CR LF and LF CR end one line (GLSL 4.60, 3.1).
            result += '\n';
            if (i + 1 < text.size() && text[i + 1] != c && (text[i + 1] == '\n' || text[i + 1] == '\r')) ++i;
        } else {
            // A NUL would end the source for some drivers.
            result += c == '\0' ? ' ' : c;
        }
    }
    return result;
}

std::vector<Token> lex(std::string_view text, std::deque<std::string>& storage, bool joinsComments) {
    if (text.find("\\\n") == std::string_view::npos) return Lexer(text, {}).run();
    JoinedText joined = joinLines(text, joinsComments);
    storage.push_back(std::move(joined.text));
    return Lexer(storage.back(), joined.joints).run();
}

}  // namespace glibra::glsl
