#pragma once
// Reads the content of functions and initialisers.

#include <span>

#include "glsl/parse/bodies.h"
#include "glsl/parse/syntax.h"

namespace glibra::glsl {

/// Walks all functions and initialisers. The depth is limited, and the time is linear in the number of
/// tokens.
Bodies walkBodies(std::span<const ViewToken> view, const Syntax& syntax);

}  // namespace glibra::glsl
