#pragma once
// The macros that exist without a #define (GLSL 4.60, 3.3 and 3.4; GLSL ES 1.00, 3.4).

#include <optional>
#include <string>
#include <string_view>

#include "glsl/read/version.h"
#include "glsl/types/request.h"

namespace glibra::glsl {

/// The text of a predefined macro whose value is the same in every line: __VERSION__, GL_ES, the profiles
/// and the extensions. Nothing for other names, and for macros that the dialect does not have.
std::optional<std::string> predefinedMacro(std::string_view name, const Dialect& dialect,
                                           const Target& target);

/// True for __LINE__ and __FILE__, whose value depends on the place.
bool isPlaceMacro(std::string_view name);

/// True for names that a source must neither define nor undefine: those of all predefined macros, and those
/// that begin with GL_.
bool isReservedMacro(std::string_view name);

}  // namespace glibra::glsl
