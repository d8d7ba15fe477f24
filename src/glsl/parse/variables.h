#pragma once
// The variables at file scope as rules change them (unit.h), and the zeros of GLSL types.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// All variables at file scope.
std::vector<Variable> collectVariables(const Unit& unit);

/// Writes the changes into the unit's edits.
void renderVariables(Unit& unit);

/// "[3]" for each size.
std::string bracketed(const std::vector<std::string>& sizes);

/// A word as the emitted source spells it, except after a '.'.
std::string spelled(const Unit& unit, const std::string& word);

// ---- Zeros
// The zeros of GLSL types as expressions.

/// The zero of a type as an expression, also of the stage's structs and of arrays. `sizes` are those of the
/// array from the outermost to the innermost. Nothing for types without a zero, for sizes that are not plain
/// numbers, and for more than `mostElements` elements.
std::optional<std::string> zeroValue(const Unit& unit, const std::string& type,
                                     std::span<const std::string> sizes, int mostElements = 1024);

/// The texts of array sizes outside of all functions, as numbers where their values are known: first those
/// after the name, then those after the type.
std::vector<std::string> sizeTexts(const Unit& unit, const std::vector<Range>& ofName,
                                   const std::vector<Range>& ofType);

}  // namespace glibra::glsl
