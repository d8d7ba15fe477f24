#pragma once
// A mesh as the driver draws it: how many pixels it covers, and the cost.

#include <glibra/result.h>

#include <optional>

#include "bench/core/bench.h"
#include "geometry/mesh.h"

namespace glibra::bench {

struct DrawnMesh {
    double area = 0;  ///< covered pixels
    Timing time;      ///< of uploading and drawing
};

/// Draws the mesh along -z without perspective, with `radius` pixels per unit, in the middle of a picture of
/// `side` x `side` pixels.
Result<DrawnMesh> drawMesh(Bench& bench, const geometry::Mesh& mesh, int side, double radius);

}  // namespace glibra::bench
