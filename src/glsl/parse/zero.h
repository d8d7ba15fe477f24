#pragma once
// The zeros of GLSL types as expressions.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glsl/parse/unit.h"

namespace glibra::glsl {

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
