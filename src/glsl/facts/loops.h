#pragma once

#include <vector>

#include "glsl/facts/counted_loop.h"
#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// The loops that main of the stage runs whose rounds constants and uniforms decide, those of the functions
/// it calls among them, once for each call. A loop that cannot be counted gives way to the loops in it.
std::vector<CountedLoop> loopsOf(const Unit& unit);

}  // namespace glibra::glsl
