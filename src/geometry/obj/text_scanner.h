#pragma once
// A cursor over a line-oriented text of numbers, fast enough for a hundred megabytes.

#include <string_view>

namespace glibra::geometry {

/// A statement ends with the line (LF, CR LF or CR) or at a `#` that begins a token. A backslash at the end
/// of a line joins the next line to it. Blanks are space, tab, vertical tab and form feed.
class TextScanner {
  public:
    explicit TextScanner(std::string_view text)
        : at_(text.data()), end_(text.data() + text.size()), lineStart_(at_) {}

    [[nodiscard]] bool atEnd() const { return at_ == end_; }
    [[nodiscard]] int line() const { return line_; }
    /// The column, in bytes from 1.
    [[nodiscard]] int column() const { return static_cast<int>(at_ - lineStart_) + 1; }
    /// The next byte; a line feed at the end of the text.
    [[nodiscard]] char current() const { return at_ == end_ ? '\n' : *at_; }
    void advance() { ++at_; }

    void skipBlanks() {
        for (;;) {
            while (at_ != end_ && isBlank(*at_)) ++at_;
            if (at_ == end_ || *at_ != '\\' || !skipJoin()) return;
        }
    }

    /// True if the statement has no further token. Call skipBlanks first.
    [[nodiscard]] bool statementEnds() const { return at_ == end_ || isLineEnd(*at_) || *at_ == '#'; }

    /// Reads everything up to a blank, a line end or a join.
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

    /// Reads the longest prefix that is a number: [+-] digits [. digits] [exponent]. Returns false and reads
    /// nothing if there is none or if it is not finite as a float. A number too small for a float is 0.
    bool number(float& value);

    /// Reads [+-] digits, limited to +-9e18. Returns false and reads nothing if there are no digits.
    bool integer(long long& value);

    /// Goes to the start of the next line that is not joined to this one.
    void nextLine();

  private:
    static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    static bool isDigit(char c) { return c >= '0' && c <= '9'; }

    /// The number of bytes of the backslash at `at` with the blanks and the line end after it; 0 if it does
    /// not join lines.
    [[nodiscard]] std::size_t joinLength(const char* at) const;
    bool skipJoin();

    const char* at_;
    const char* end_;
    const char* lineStart_;
    int line_ = 1;
};

}  // namespace glibra::geometry
