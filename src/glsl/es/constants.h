#pragma once
// The numbers of constant expressions.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The components of a constant expression of literals, constructors, arithmetic and constants of the file,
/// computed in single precision; matrices by columns, booleans as 0 and 1. Nothing for other expressions.
std::optional<std::vector<double>> constantNumbers(const Unit& unit, std::uint32_t node);

/// Adds the values that the expression at `node` gives a uniform of that name and type. False if one of them
/// is no constant.
bool addInitialValues(const Unit& unit, const std::string& uniform, std::string_view type, std::uint32_t node,
                      std::vector<InitialValue>& values);

}  // namespace glibra::glsl
