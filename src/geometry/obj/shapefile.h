#pragma once
// ESRI shapefiles: the main file (.shp).

#include <glibra/result.h>

#include <cstddef>
#include <span>
#include <string>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Polylines and the rings of polygons as lines, rings closed; points and multipoints as points; in file
/// order, z where the type has it, else 0, measures ignored. Coordinates are those of the file rounded to
/// float, neither moved nor scaled. Normal (0, 0, 1), tangent (0, 1, 0), no texture coordinates. Null shapes
/// are skipped, multipatches too (file-W11). Errors: file-E04 where lengths, counts or coordinates cannot be
/// true, file-E09 beyond the limits of obj_model.h. Any bytes may be given; `path` is for messages. Format:
/// ESRI Shapefile Technical Description, 1998.
Result<Mesh> parseShp(std::span<const std::byte> bytes, std::string path);

}  // namespace glibra::geometry
