#pragma once
// Which variables of a stage may be read, or leave the stage, before they have a value. A variable counts as
// assigned where it is on every path (definite assignment; The Java Language Specification, chapter 16).
// Vectors, matrices, small arrays and structures are followed part by part.

#include "glsl/facts/unassigned.h"
#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Looks at all functions of the stage. Call it after placeFragmentOutputs, where there are rules.
Assignments findUnassigned(const Unit& unit);

}  // namespace glibra::glsl
