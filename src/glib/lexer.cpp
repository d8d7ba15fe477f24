#include "glib/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/text.h"
#include "glib/limits.h"
#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr std::size_t kUsualTokens = 8;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::string_view kOpening = "<[{(";
constexpr std::string_view kClosing = ">]})";

constexpr bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
constexpr bool isControl(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && !isBlank(c)) || byte == 0x7f;
}

/// The bytes at which a word may end. Most bytes are not among them and need no closer look.
constexpr auto kMayEndWord = [] {
    std::array<bool, 256> may{};
    for (std::size_t byte = 0; byte < may.size(); ++byte) {
        const char c = static_cast<char>(byte);
        may[byte] = isBlank(c) || isControl(c) || kOpening.find(c) != std::string_view::npos ||
                    kClosing.find(c) != std::string_view::npos || c == '#' || c == '/' || c == '\xc2' ||
                    c == '\xa0';
    }
    return may;
}();
bool mayEndWord(char c) {
    return kMayEndWord[static_cast<unsigned char>(c)];
}

/// Reads the tokens of one line. Offsets count from the start of the file.
class LineReader {
  public:
    LineReader(std::string_view text, const LineRange& range, MessageLines messages, MessageLog& log,
               Parentheses parentheses)
        : text_(text.substr(0, range.end)), messages_(messages), parentheses_(parentheses), log_(log) {
        line_.range = row_ = range;
        at_ = range.begin;
        hasBreaks_ = text_.find_first_of("\r\n", at_) != std::string_view::npos;
    }

    Line read() {
        if (line_.range.end - line_.range.begin > kLongestLine) {
            log_.report("glib-E15",
                        fmt::format("line of {} bytes; the limit is {}",
                                    base::groupedText(line_.range.end - line_.range.begin),
                                    base::groupedText(kLongestLine)),
                        position(at_));
            line_.faulty = line_.tooLong = true;
            return std::move(line_);
        }
        reportControlByte();
        line_.tokens.reserve(kUsualTokens);
        while (skipBlanks()) readToken();
        return std::move(line_);
    }

  private:
    /// Offsets come in rising order, but for a few steps back on the same line.
    Position position(std::size_t offset) {
        if (offset < row_.begin) row_ = line_.range;
        while (hasBreaks_) {
            const std::size_t end = text_.find_first_of("\r\n", row_.begin);
            if (end >= offset) break;
            row_.begin = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
            ++row_.number;
        }
        return {row_.number, static_cast<int>(offset - row_.begin) + 1};
    }

    void reportControlByte() {
        for (std::size_t i = line_.range.begin; i < line_.range.end; ++i) {
            if (!isControl(text_[i]) || text_[i] == '\n' || text_[i] == '\r') continue;
            log_.report("glib-E03",
                        fmt::format("byte 0x{:02x} at offset {}: this is not a text file",
                                    static_cast<unsigned>(static_cast<unsigned char>(text_[i])), i),
                        position(i));
            line_.faulty = true;
            return;
        }
    }

    /// The length in bytes of a no-break space at `offset`: U+00A0 in UTF-8, or the byte A0 of Latin-1 if it
    /// cannot be part of a UTF-8 character. 0 if there is none.
    std::size_t noBreakSpaceAt(std::size_t offset) const {
        if (text_[offset] == '\xc2') return text_.substr(offset, 2) == "\xc2\xa0" ? 2 : 0;
        if (text_[offset] != '\xa0') return 0;
        const bool afterAscii = offset == line_.range.begin || offset == afterNoBreakSpace_ ||
                                static_cast<unsigned char>(text_[offset - 1]) < 0x80;
        return afterAscii ? 1 : 0;
    }

    bool atComment(std::size_t offset) const {
        return text_[offset] == '#' || (text_[offset] == '/' && text_.substr(offset, 2) == "//");
    }

    /// Goes to the next token. Returns false at the end of the line's code.
    bool skipBlanks() {
        for (; at_ < text_.size(); ++at_) {
            if (isBlank(text_[at_]) || isControl(text_[at_])) continue;
            const std::size_t noBreakSpace = noBreakSpaceAt(at_);
            if (noBreakSpace == 0) break;
            if (afterNoBreakSpace_ == 0)
                log_.report("glib-W35", "no-break space read as a blank", position(at_));
            at_ += noBreakSpace - 1;
            afterNoBreakSpace_ = at_ + 1;
        }
        if (at_ >= text_.size()) return false;
        const bool comment = atComment(at_);
        if (comment || text_[at_] == '/') {
            if (!comment)
                log_.report("glib-W01",
                            "a single '/' starts a comment here; use '//' or '#', or quote the path",
                            position(at_));
            line_.isComment = true;
            return false;
        }
        return true;
    }

    void readToken() {
        const char c = text_[at_];
        if (c == '"')
            readQuoted();
        else if (c == '(' && parentheses_ != Parentheses::brackets && readExpression())
            return;
        else if (mayEndWord(c) && kOpening.find(c) != std::string_view::npos)
            add(TokenKind::open, at_, at_ + 1, text_.substr(at_, 1));
        else if (mayEndWord(c) && kClosing.find(c) != std::string_view::npos)
            add(TokenKind::close, at_, at_ + 1, text_.substr(at_, 1));
        else
            readWord();
    }

    /// Returns false if the parenthesis is a bracket.
    bool readExpression() {
        if (!expressions_) expressions_.emplace(text_, at_);
        const std::size_t end = expressions_->endAt(at_, parentheses_);
        if (end == 0) return false;
        add(TokenKind::expression, at_, end, text_.substr(at_ + 1, end - at_ - 2));
        return true;
    }

    void readQuoted() {
        const std::size_t close = text_.find('"', at_ + 1);
        if (close != std::string_view::npos)
            return add(TokenKind::quoted, at_, close + 1, text_.substr(at_ + 1, close - at_ - 1));
        log_.report("glib-E02", "quoted name is not closed on this line", position(at_));
        line_.faulty = true;
        add(TokenKind::quoted, at_, text_.size(), text_.substr(at_ + 1));
    }

    bool endsWord(std::size_t offset) const {
        const char c = text_[offset];
        return isBlank(c) || isControl(c) || kOpening.find(c) != std::string_view::npos ||
               kClosing.find(c) != std::string_view::npos || atComment(offset) || noBreakSpaceAt(offset) > 0;
    }

    void readWord() {
        const std::size_t begin = at_;
        std::size_t end = begin;
        while (end < text_.size() && !(mayEndWord(text_[end]) && endsWord(end))) ++end;
        const std::size_t wordEnd = end;  // before anything is removed
        if (text_[end - 1] == '\\' && isLastOnLine(end)) {
            line_.continues = true;
            line_.backslash = position(--end);
        }
        const std::string_view written = text_.substr(begin, end - begin);
        std::string_view word = written;
        while (!word.empty() && (word.back() == ',' || word.back() == ';')) word.remove_suffix(1);
        if (word.size() < written.size() && !std::exchange(hasDropped_, true)) {
            log_.report("glib-W03",
                        fmt::format("{} at the end of {} dropped; blanks separate values",
                                    inQuotes(written.substr(word.size())), inQuotes(written)),
                        position(begin));
        }
        if (line_.tokens.empty() && messages_ == MessageLines::rawText && sameWord(word, "MessageBox")) {
            line_.continues = false;
            add(TokenKind::word, begin, begin + word.size(), word);
            return readMessage(begin + written.size());
        }
        at_ = wordEnd;
        if (word.empty()) return;
        add(numberLength(word) > 0 ? TokenKind::number : TokenKind::word, begin, begin + word.size(), word);
        at_ = wordEnd;
    }

    /// True if only blanks and a comment follow; after a backslash they are reported.
    bool isLastOnLine(std::size_t end) {
        std::size_t next = end;
        while (next < text_.size() && (isBlank(text_[next]) || noBreakSpaceAt(next) > 0))
            next += std::max<std::size_t>(1, noBreakSpaceAt(next));
        const bool comment = next < text_.size() && (atComment(next) || (text_[next] == '/' && next > end));
        if (next < text_.size() && !comment) return false;
        if (next > end)
            log_.report("glib-W02", "text after the continuation backslash ignored", position(end - 1));
        return true;
    }

    void readMessage(std::size_t begin) {
        std::size_t end = text_.size();
        while (begin < end && isBlank(text_[begin])) ++begin;
        while (end > begin && isBlank(text_[end - 1])) --end;
        line_.isMessage = true;
        line_.message = text_.substr(begin, end - begin);
        line_.messageEnd = end;
        at_ = text_.size();
    }

    void add(TokenKind kind, std::size_t begin, std::size_t end, std::string_view text) {
        line_.tokens.push_back({kind, text, begin, end, position(begin)});
        at_ = end;
    }

    std::string_view text_;  ///< the file up to the end of this line
    MessageLines messages_;
    Parentheses parentheses_;
    MessageLog& log_;
    std::optional<ExpressionFinder> expressions_;
    Line line_;
    std::size_t at_ = 0;
    bool hasBreaks_ = false;             ///< there are several lines
    bool hasDropped_ = false;            ///< glib-W03 has been reported for this line
    LineRange row_;                      ///< the line of the last position; its end is not used
    std::size_t afterNoBreakSpace_ = 0;  ///< offset after the last one; 0: none on this line yet
};

}  // namespace

std::optional<bool> Token::truth() const {
    if (kind != TokenKind::word) return std::nullopt;
    if (sameWord(text, "true")) return true;
    if (sameWord(text, "false")) return false;
    return std::nullopt;
}

ReadNumber readNumber(const Token& token, MessageLog& log, std::string_view hint) {
    const std::optional<NumberPrefix> number =
        token.kind == TokenKind::number ? numberPrefix(token.text) : std::optional<NumberPrefix>();
    if (!number) {
        const bool isName = !token.text.empty() && isLetter(token.text[0]);
        log.report("glib-W05",
                   fmt::format("{} is not a number, 0 used{}", inQuotes(token.text), isName ? hint : ""),
                   token.position);
        return {0, "0"};
    }
    const std::string_view text = token.text.substr(0, number->length);
    if (number->length < token.text.size())
        log.report("glib-W04",
                   fmt::format("{} read as {}, {} ignored", inQuotes(token.text), text,
                               inQuotes(token.text.substr(number->length))),
                   token.position);
    if (!number->finite)
        log.report("glib-E31", fmt::format("{} is too large for a 32-bit float", inQuotes(text)),
                   token.position);
    return {number->finite ? number->value : 0, text};
}

LineSplitter::LineSplitter(std::string_view text) : text_(text) {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

std::optional<LineRange> LineSplitter::next() {
    if (at_ >= text_.size()) return std::nullopt;
    const std::size_t begin = at_;
    std::size_t end = begin;
    while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
    at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
    return LineRange{++number_, begin, end};
}

Line readLine(std::string_view text, const LineRange& range, MessageLines messages, MessageLog& log,
              Parentheses parentheses) {
    return LineReader(text, range, messages, log, parentheses).read();
}

bool goesOnInParentheses(std::string_view text, const LineRange& range, int& depth) {
    std::string_view code = text.substr(range.begin, range.end - range.begin);
    for (std::size_t at = 0; at < code.size(); ++at) {
        const char c = code[at];
        if (c == '#' || code.substr(at, 2) == "//")
            code = code.substr(0, at);
        else if (c == '"')
            at = std::min(code.find('"', at + 1), code.size());
        else
            depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    }
    const std::size_t last = code.find_last_not_of(" \t\v\f");
    return depth > 0 && last != std::string_view::npos && code[last] == '\\';
}

LineStart startOf(std::string_view text, const LineRange& range) {
    const std::string_view line = text.substr(range.begin, range.end - range.begin);
    std::size_t at = 0;
    const auto nextWord = [&] {
        while (at < line.size() && isBlank(line[at])) ++at;
        const std::size_t begin = at;
        while (at < line.size() && !mayEndWord(line[at])) ++at;
        return line.substr(begin, at - begin);
    };
    LineStart start;
    start.word = nextWord();
    if (at < line.size() && isBlank(line[at])) start.next = nextWord();
    return start;
}

// ---- Expressions.

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

// ---- Bracket groups.

namespace {

/// True for words that can only be tags, and so end an unclosed group.
bool endsGroup(const Token& token) {
    if (token.kind == TokenKind::open || token.kind == TokenKind::quoted) return true;
    if (token.kind != TokenKind::word || token.truth()) return false;
    return isLetter(token.text.front()) || token.text.front() == '_';
}

}  // namespace

BracketGroup groupAt(std::span<const Token> tokens, std::size_t open) {
    BracketGroup group;
    group.first = open + 1;
    std::size_t at = group.first;
    while (at < tokens.size() && tokens[at].kind != TokenKind::close && !endsGroup(tokens[at])) ++at;
    group.last = group.next = at;
    group.end = GroupEnd::notClosed;
    if (at < tokens.size() && tokens[at].kind == TokenKind::close) {
        group.next = at + 1;
        group.end =
            bracketsMatch(tokens[open].text, tokens[at].text) ? GroupEnd::closed : GroupEnd::wrongBracket;
    }
    return group;
}

std::size_t valueEnd(std::span<const Token> tokens, std::size_t at) {
    return tokens[at].kind == TokenKind::open ? groupAt(tokens, at).next : at + 1;
}

bool readsAsPairs(std::span<const Token> tokens) {
    if (tokens.size() < 2 || !tokens[1].beginsValue()) return false;
    for (std::size_t at = 0; at < tokens.size();) {
        if (!tokens[at].isWord()) return false;
        ++at;
        if (at < tokens.size() && tokens[at].beginsValue()) at = valueEnd(tokens, at);
    }
    return true;
}

bool bracketsMatch(std::string_view open, std::string_view close) {
    return kOpening.find(open) == kClosing.find(close);
}

void reportGroupEnd(std::span<const Token> tokens, std::size_t open, const BracketGroup& group,
                    MessageLog& log) {
    if (group.end == GroupEnd::wrongBracket)
        log.report("glib-W08", fmt::format("'{}' closed by '{}'", tokens[open].text, tokens[group.last].text),
                   tokens[group.last].position);
    if (group.end == GroupEnd::notClosed)
        log.report("glib-W09",
                   fmt::format("'{}' not closed; closed {}", tokens[open].text,
                               group.next < tokens.size() ? "before " + inQuotes(tokens[group.next].text)
                                                          : std::string("at the end of the statement")),
                   tokens[open].position);
}

}  // namespace glibra::glib
