#pragma once
// Finds the expressions of a line: which parentheses begin one, and where they end.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace glibra::glib {

/// What parentheses mean on a line.
enum class Parentheses : std::uint8_t {
    brackets,     ///< they are always brackets
    byContent,    ///< an expression, if they hold a word or an operator; else brackets (classic commands)
    expressions,  ///< always an expression (modern statements)
};

/// The pairs of parentheses of one line.
class ExpressionFinder {
  public:
    /// Looks at `code` from offset `from` up to the first comment. Takes time in proportion to the line.
    ExpressionFinder(std::string_view code, std::size_t from);

    /// Returns the offset after the partner of the parenthesis at `open`, if the pair is an expression; 0 if
    /// it is not.
    [[nodiscard]] std::size_t endAt(std::size_t open, Parentheses parentheses) const;

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    void look(std::string_view code);

    std::size_t from_;
    std::vector<std::size_t> partner_;   ///< by offset - from_; kNone: no parenthesis, or not closed
    std::vector<std::size_t> nextSign_;  ///< offset of the next word or operator at or after this one
};

/// How deep the parentheses of the text are nested.
std::size_t depthOf(std::string_view expression);

}  // namespace glibra::glib
