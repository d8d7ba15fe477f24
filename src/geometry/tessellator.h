#pragma once
// The tessellator of OpenGL (4.6 Core, 11.2.2), for drivers that have none.

#include <array>
#include <vector>

#include "base/tessellation_layout.h"

namespace glibra::geometry {

/// gl_TessCoord for each vertex of the primitives that a patch becomes, one after the other: 3 of a triangle,
/// 2 of a line, 1 of a point. `levels`: four outer ones, two inner ones. Empty if an outer level that the
/// domain uses is not positive or no number, because the patch is dropped then. Levels are limited to 64.
///
/// Where OpenGL leaves it open, vertices stand and are joined as Direct3D 11 defines it (Direct3D 11.3
/// Functional Specification, 14.7), which most drivers do: coordinates are multiples of 2^-16.
std::vector<std::array<float, 3>> tessellate(const base::TessellationLayout& layout,
                                             const std::array<float, 6>& levels);

}  // namespace glibra::geometry
