#pragma once
// The teapot.

#include <array>
#include <glm/vec3.hpp>

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

// The control points of the classic teapot.

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

constexpr Counts teapotCounts(std::int64_t cells = 16) {
    return detail::counted(32 * (cells + 1) * (cells + 1), 64 * cells * cells - 8 * cells);
}
constexpr Counts wireTeapotCounts() {
    return {2592, 4544};
}

/// From the patches' original coordinates to model space: (x, y, z) -> (.5 x, .5 (z - 1.5), -.5 y).
glm::dvec3 teapotPlace(const glm::dvec3& original);

/// Makes the 32 patches of `teapotPatches` in their order, as triangles that are counter-clockwise seen from
/// outside. Each patch is a grid of cells x cells with its own vertices (cells >= 2),
/// moved by `teapotPlace`: y up, from -.75 to .825, the spout toward +x. s and t run from 0 to 1 on every
/// patch. Normals are the cross product of the derivatives. Triangles without area, at the knob and at the
/// centre of the bottom, are left out. Neighbouring patches have equal positions along their common edge.
/// Size: teapotCounts.
Mesh teapot(int cells = 16);

/// Makes the patches as grids of 8 x 8 cells: all grid lines but those that are a point. Size:
/// wireTeapotCounts.
Mesh wireTeapot();

extern const PrimitiveSpec kTeapotRow;
extern const PrimitiveSpec kWireTeapotRow;

}  // namespace glibra::geometry
