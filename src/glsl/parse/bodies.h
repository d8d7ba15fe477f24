#pragma once
// Reads the statements and expressions of a stage into a tree (tree.h).

#include <span>

#include "glsl/parse/tree.h"

namespace glibra::glsl {

/// Parses all functions and initialisers, and sets Declaration::code and Declarator::value. The depth is
/// limited, and the time is linear in the number of tokens.
Bodies parseBodies(std::span<const ViewToken> view, Syntax& syntax);

}  // namespace glibra::glsl
