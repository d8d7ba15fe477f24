#pragma once
// Where the statements of a function end, and where its loops begin.

#include <cstdint>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Finds the ends of statements by their words and brackets. All positions are view indices.
class Statements {
  public:
    explicit Statements(const Unit& unit) : unit_(unit) {}

    /// True for the `for`, `while` or `do` that begins a loop. The `while` that ends a `do` looks like one.
    [[nodiscard]] bool isLoop(std::uint32_t at) const;
    /// The statement that the loop at `at` repeats.
    [[nodiscard]] Range body(std::uint32_t at, std::uint32_t end) const;
    /// The index after `do ... while (...)`.
    [[nodiscard]] std::uint32_t afterDo(std::uint32_t at, std::uint32_t end) const;
    /// The index after `for (...)`, `while (...)`, `if (...)`, `switch (...)` or `do` at `at`; `at` if there
    /// is none.
    [[nodiscard]] std::uint32_t afterHead(std::uint32_t at, std::uint32_t end) const;
    /// The index after the statement that begins at `at`.
    [[nodiscard]] std::uint32_t end(std::uint32_t at, std::uint32_t end) const;

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }

    const Unit& unit_;
};

}  // namespace glibra::glsl
