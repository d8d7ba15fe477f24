#pragma once
// GLSL ES converts no types by itself.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Writes the conversions of integers that GLSL makes by itself (GLSL 4.60, 4.1.10): in operators,
/// assignments, initialisers, selections, and arguments of functions and of constructors of structures and
/// arrays. Values that functions return are left to adaptToTarget(). Expressions of an unknown type stay.
void writeConversions(Unit& unit);

}  // namespace glibra::glsl
