#pragma once
// A cursor over a line-oriented text of numbers, fast enough for a hundred megabytes.

#include <string_view>

namespace glibra::geometry {

/// Statements end with the line (LF, CR LF or CR) or with a `#` that begins a token. A backslash at the end
/// of a line joins the next one to it. Blanks are space, tab, vertical tab and form feed.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text)
        : at_(text.data()), end_(text.data() + text.size()), lineStart_(at_) {}

    [[nodiscard]] bool atEnd() const { return at_ == end_; }
    [[nodiscard]] int line() const { return line_; }
    /// From 1, in bytes.
    [[nodiscard]] int column() const { return static_cast<int>(at_ - lineStart_) + 1; }
    /// The next byte, a line feed at the end.
    [[nodiscard]] char current() const { return at_ == end_ ? '\n' : *at_; }
    void advance() { ++at_; }

    void skipBlanks() {
        for (;;) {
            while (at_ != end_ && isBlank(*at_)) ++at_;
            if (at_ == end_ || *at_ != '\\' || !skipJoin()) return;
        }
    }

    /// True where no further token stands in the statement; to be asked after skipBlanks.
    [[nodiscard]] bool statementEnds() const { return at_ == end_ || isLineEnd(*at_) || *at_ == '#'; }

    /// Everything up to a blank, a line end or a join.
    std::string_view token() {
        const char* const start = at_;
        while (at_ != end_ && !isBlank(*at_) && !isLineEnd(*at_) && !(*at_ == '\\' && joinLength(at_) > 0))
            ++at_;
        return {start, static_cast<std::size_t>(at_ - start)};
    }

    /// True if a token ends here.
    [[nodiscard]] bool tokenEnds() const {
        return at_ == end_ || isBlank(*at_) || isLineEnd(*at_) || (*at_ == '\\' && joinLength(at_) > 0);
    }

    /// Reads the longest prefix that is a number: [+-] digits [. digits] [exponent]. False, and nothing is
    /// read, if there is none or if it is not finite as a float; a number too small for a float is 0.
    bool number(float& value);

    /// Reads [+-] digits; what does not fit is limited to +-9e18. False, and nothing is read, if there are
    /// none.
    bool integer(long long& value);

    /// Goes to the start of the next line, over joined ones, too.
    void nextLine();

  private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    static bool isDigit(char c) { return c >= '0' && c <= '9'; }

    /// Bytes of the backslash at `at`, blanks and the line end behind it; 0 if it joins nothing.
    [[nodiscard]] std::size_t joinLength(const char* at) const;
    bool skipJoin();

    const char* at_;
    const char* end_;
    const char* lineStart_;
    int line_ = 1;
};

}  // namespace glibra::geometry
