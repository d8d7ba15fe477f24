#pragma once
// Scalar expressions of a stage as formulas of constants and uniforms.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/counted_loop.h"

namespace glibra::glsl {

/// Looks at ranges of a stage's tokens. The work is limited, because functions are read once per call and a
/// hostile source can nest them.
class TokenSearch {
  public:
    explicit TokenSearch(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] const Unit& unit() const { return unit_; }
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] bool isWord(std::uint32_t at) const { return unit_.view[at].kind == TokenKind::word; }
    /// The index of the bracket that closes the one at `at`; past the end if there is none.
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] bool opens(std::uint32_t at) const;

    /// Counts tokens that are looked at; false when the limit is reached and the search has to stop.
    bool spend(std::size_t tokens);
    /// The ranges between the separators in a range. Separators inside brackets do not count.
    [[nodiscard]] std::vector<Range> parts(Range range, std::string_view separator) const;
    /// True if the token at `at` changes the variable of that name.
    [[nodiscard]] bool isChange(std::string_view name, std::uint32_t at) const;
    /// True if a token in the range changes it, or if the limit is reached.
    bool changes(std::string_view name, Range range);

    /// The local variable that the word at `at` names, if there is only one and it keeps the value that its
    /// declaration gives it.
    const LocalVariable* keptLocal(std::uint32_t at);

    /// The value of an expression; nothing if it depends on anything that a Formula does not have.
    std::optional<Formula> formula(Range range);

  private:
    bool append(Range range, Formula& to);
    bool sum(std::uint32_t& at, std::uint32_t end, Formula& to);
    bool product(std::uint32_t& at, std::uint32_t end, Formula& to);
    bool operand(std::uint32_t& at, std::uint32_t end, Formula& to);
    bool primary(std::uint32_t& at, std::uint32_t end, Formula& to);
    bool call(std::string_view function, Range inside, Formula& to);
    bool name(std::uint32_t at, Formula& to);
    bool local(std::uint32_t at, Formula& to);
    /// A size with its component, or a member of a block, at `at`; `at` moves behind it.
    bool measure(std::uint32_t& at, std::uint32_t end, Formula& to);
    /// "imageSize(uMap)" for a call in the range; empty if it is none.
    std::string sizeCall(Range range);

    const Unit& unit_;
    std::size_t spent_ = 0;
    int depth_ = 0;
};

}  // namespace glibra::glsl
