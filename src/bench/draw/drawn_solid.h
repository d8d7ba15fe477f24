#pragma once
// A mesh as the driver draws it: how many pixels it covers, and what that costs.

#include <glibra/result.h>

#include <optional>

#include "bench/core/bench.h"
#include "geometry/mesh.h"

namespace glibra::bench {

struct DrawnMesh {
    double area = 0;  ///< covered pixels
    Timing time;      ///< uploading and drawing it
};

/// Seen along -z without perspective, `radius` pixels a unit, in the middle of a picture of `side` pixels.
Result<DrawnMesh> drawMesh(Bench& bench, const geometry::Mesh& mesh, int side, double radius);

}  // namespace glibra::bench
