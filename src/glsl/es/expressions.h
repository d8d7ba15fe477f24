#pragma once
// GLSL ES converts no types by itself.

#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Writes the conversions of integers that GLSL makes by itself (GLSL 4.60, 4.1.10): in operators,
/// assignments, initialisers, selections, and arguments of functions and of constructors of structures and
/// arrays. Values that functions return are left to adaptToTarget(). Expressions of an unknown type stay.
void writeConversions(Unit& unit);

// The values of initialisers of uniforms.

/// Adds the values that the expression at `node` gives a uniform of that name and type. False if one of them
/// is no constant.
bool addInitialValues(const Unit& unit, const std::string& uniform, std::string_view type, std::uint32_t node,
                      std::vector<InitialValue>& values);

}  // namespace glibra::glsl
