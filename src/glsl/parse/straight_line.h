#pragma once
// Statements that main always executes.

#include <optional>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// The body of main with its braces; nothing if there is no main, or several.
std::optional<Range> bodyOfMain(const Unit& unit);

/// True if the statement that begins at `at` is directly in the braces of `body`, is not governed by an if,
/// else or loop, and comes after no return.
bool isAlwaysExecuted(const Unit& unit, Range body, std::uint32_t at);

/// True for a literal 1 of type int or float.
bool isLiteralOne(std::string_view number);

}  // namespace glibra::glsl
