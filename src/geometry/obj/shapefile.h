#pragma once
// ESRI shapefiles: the main file (.shp).

#include <glibra/result.h>

#include <cstddef>
#include <span>
#include <string>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Reads a shapefile; `path` is for messages. It may hold any bytes.
///
/// Polylines and the rings of polygons become lines, with the rings closed; points and multipoints become
/// points. They keep the order of the file. z is that of the file, or 0 if the type has none; measures are
/// ignored. Coordinates are rounded to float, but not moved or scaled. Normal (0, 0, 1), tangent (0, 1, 0),
/// no texture coordinates. Null shapes are skipped, and so are multipatches (file-W11). Errors: file-E04 if
/// lengths, counts or coordinates are impossible, file-E09 beyond the limits of obj_model.h. Format: ESRI
/// Shapefile Technical Description, 1998.
Result<Mesh> parseShp(std::span<const std::byte> bytes, std::string path);

}  // namespace glibra::geometry
