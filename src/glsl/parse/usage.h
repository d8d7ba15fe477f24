#pragma once
// Which names a stage declares, uses and changes.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Fills `declared`, `uses` and `writes` of the unit.
void findUsage(Unit& unit);

/// True if the name at `at`, or a part of it, is assigned to there, incremented or decremented.
bool isWrittenAt(const Unit& unit, std::uint32_t at);

/// Past the subscripts and members behind the name at `at`: the index of what follows.
std::uint32_t behindSuffixes(const Unit& unit, std::uint32_t at);

/// The value of a constant index like the 2 of name[2]; -1 for anything else.
int constantIndex(const Unit& unit, std::uint32_t openBracket);

/// The value of an integer expression of literals; false if it is none.
bool integerValue(const Unit& unit, Range range, long long& value);

}  // namespace glibra::glsl
