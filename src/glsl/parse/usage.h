#pragma once
// Which names a stage declares, uses and changes.

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "glsl/parse/unit.h"
#include "glsl/read/words.h"

namespace glibra::glsl {

/// Fills `declared`, `uses` and `writes` of the unit.
void findUsage(Unit& unit);

/// The arguments that a built-in function writes, as bits: `modf(x, whole)`.
unsigned builtinOutputs(std::string_view function);

/// True if the evaluation of the expression changes nothing: no assignment, and no call but of constructors.
bool isIdle(const Unit& unit, Range range);

/// The functions, of the stage and built in, that write to an argument in any of their overloads.
std::set<std::string_view> functionsThatWriteArguments(const Unit& unit);

/// True if the name at `at`, or a part of its value, is assigned to, incremented or decremented there.
bool isWrittenAt(const Unit& unit, std::uint32_t at);

/// The index after the name at `at` and the subscripts and members that follow it.
std::uint32_t afterSuffixes(const Unit& unit, std::uint32_t at);

/// The value of a constant index, such as 2 in name[2]; -1 for anything else.
int constantIndex(const Unit& unit, std::uint32_t openBracket);

/// Gives `value` the value of an integer expression of literals; false if the range is not such an
/// expression.
bool integerValue(const Unit& unit, Range range, long long& value);

/// The same for a range outside of all functions, which may also name constants and convert: int(kLights).
bool globalIntegerValue(const Unit& unit, Range range, long long& value);

/// The text of an array size outside of all functions: a number, if its value is known.
std::string sizeText(const Unit& unit, Range range);

/// The body of main with its braces; nothing if there is no main, or several.
std::optional<Range> bodyOfMain(const Unit& unit);

/// True if the statement that begins at `at` is directly in the braces of `body`, is not governed by an if,
/// else or loop, and comes after no return.
bool isAlwaysExecuted(const Unit& unit, Range body, std::uint32_t at);

/// True for a literal 1 of type int or float.
bool isLiteralOne(std::string_view number);

/// The condition of a loop, from the token before it to the token after it. `head`: the brackets.
Range conditionOf(const Unit& unit, const Node& loop, Range head);
/// The token after which the value of that condition begins: that before the condition, or the '=' of
/// `while (bool goesOn = f())`.
std::uint32_t beforeValue(const Unit& unit, Range condition);

}  // namespace glibra::glsl
