#pragma once
// The control points of the classic teapot.

#include <array>
#include <glm/vec3.hpp>

namespace glibra::geometry {

/// Control points of a bicubic patch: [row][column], rows along t, columns along s.
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;

/// Returns the 32 patches in the original coordinates (z up, bottom at z = 0, lid at z = 3.15, spout toward
/// +x): rim 4, body 8, lid 8, bottom 4, handle 4, spout 4. On the surfaces of revolution t follows the
/// profile from the centre of the bottom to the knob, on the spout the length from the body to the tip, on
/// the handle the length from the upper to the lower joint. s runs in the direction for which dP/ds x dP/dt
/// points out of the body. Neighbours share control points bit for bit.
///
/// Source: Martin Newell, The Utilization of Procedure Models in Digital Image Synthesis, dissertation,
/// University of Utah, 1975; the numbers as printed by Frank Crow, The Origins of the Teapot, IEEE CG&A 7(1),
/// 1987, with the knob's degenerate row drawn together into one point.
std::array<Patch, 32> teapotPatches();

/// The index of the first patch of each part.
inline constexpr int kTeapotRim = 0, kTeapotBody = 4, kTeapotLid = 12, kTeapotBottom = 20, kTeapotHandle = 24,
                     kTeapotSpout = 28;

}  // namespace glibra::geometry
