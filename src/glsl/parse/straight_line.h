#pragma once
// What main executes whatever happens.

#include <optional>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// The braces of the only function main and what is between them; nothing if there is none, or several.
std::optional<Range> bodyOfMain(const Unit& unit);

/// True if the statement that begins at `at` stands directly in the braces of `body`, begun by no if, else or
/// loop, and behind no return.
bool isAlwaysExecuted(const Unit& unit, Range body, std::uint32_t at);

/// A literal 1 as an int or a float.
bool isLiteralOne(std::string_view number);

}  // namespace glibra::glsl
