#pragma once
// The values of initialisers of uniforms.

#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Adds the values that the expression at `node` gives a uniform of that name and type. False if one of them
/// is no constant.
bool addInitialValues(const Unit& unit, const std::string& uniform, std::string_view type, std::uint32_t node,
                      std::vector<InitialValue>& values);

}  // namespace glibra::glsl
