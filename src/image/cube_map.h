#pragma once
// One picture as the six faces of a cube map: a panorama or a cross.

#include <glibra/result.h>

#include <array>

#include "base/files.h"
#include "image/image.h"
#include "image/read.h"

namespace glibra::image {

/// The faces in GL's order (+x -x +y -y +z -z), as readCubeMap gives them, of one picture:
/// - 2:1, a panorama: the longitude runs along a row, with -z in the middle and +x a quarter to the right;
///   the top row is +y. Faces have a quarter of its width as their side; a texel is the mean of four
///   bilinear samples.
/// - 4:3, a cross: +y above and -y below +z in the row -x +z +x -z. Its texels are copied.
/// Errors: those of readImage; file-E06 for another shape.
Result<TexelBlock> readCubePicture(const base::FileSource& source, const Place& place = {},
                                   const ReadOptions& options = {});

/// The direction (not normalised) that GL's cube map of that face reads at s, t in 0..1, where the first row
/// has t = 0 (OpenGL 4.6, table 8.19).
std::array<double, 3> cubeDirection(int face, double s, double t);

}  // namespace glibra::image
