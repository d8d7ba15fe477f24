#pragma once
// Scalar expressions of a stage as formulas of constants and uniforms.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "glsl/parse/unit.h"
#include "glsl/types/counted_loop.h"

namespace glibra::glsl {

/// Finds out what variables and expressions are. The work is limited, because functions are read once per
/// call and a hostile source can nest them.
class FormulaSearch {
  public:
    explicit FormulaSearch(const Unit& unit) : unit_(unit) {}

    /// Counts tokens that are looked at; false when the limit is reached and the search has to stop.
    bool spend(std::size_t tokens);
    /// True if the token at `at` changes the variable of that name.
    [[nodiscard]] bool isChange(std::string_view name, std::uint32_t at) const;
    /// True if a token in the range changes it, or if the limit is reached.
    bool changes(std::string_view name, Range range);

    /// The local variable that the word at `at` names, if there is only one and it keeps the value that its
    /// declaration gives it.
    const LocalVariable* keptLocal(std::uint32_t at);

    /// The value of an expression, or of a chain without its first operand; nothing if it depends on anything
    /// that a Formula does not have.
    std::optional<Formula> formula(std::uint32_t expression, bool skipsFirst = false);

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }

    bool append(std::uint32_t expression, Formula& to);
    bool add(std::uint32_t expression, Formula& to, bool skipsFirst);
    bool chain(std::uint32_t expression, Formula& to, bool skipsFirst);
    bool prefix(const Node& expression, Formula& to);
    bool call(const Node& call, Formula& to);
    bool name(std::uint32_t at, Formula& to);
    /// A size with its component, or a member of a block.
    bool measure(std::uint32_t expression, Formula& to);
    [[nodiscard]] bool isBlockName(std::string_view name, bool asInstance) const;
    /// "imageSize(uMap)" for a call of it; empty for all else.
    [[nodiscard]] std::string sizeCall(std::uint32_t expression) const;

    const Unit& unit_;
    std::size_t spent_ = 0;
    int depth_ = 0;
};

}  // namespace glibra::glsl
