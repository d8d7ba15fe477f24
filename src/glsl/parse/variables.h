#pragma once
// The variables at file scope as the rules change them. All rules work on these values, and the tokens are
// changed once at the end, so that several rules can change one declaration.

#include <string>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// All variables at file scope.
std::vector<Variable> collectVariables(const Unit& unit);

/// Writes the changes into the unit's edits.
void renderVariables(Unit& unit);

/// A word as the emitted source spells it, except after a '.'.
std::string spelled(const Unit& unit, const std::string& word);

}  // namespace glibra::glsl
