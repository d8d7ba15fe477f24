#include "geometry/shapes/disk.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {

Mesh diskXY(double z, double radius, int slices, int rings) {
    assert(radius >= 0 && slices >= 3 && rings >= 1);
    Surface surface(Topology::triangles, 2, diskXYCounts(slices, rings));
    const Axis facing{.along = {0, 0, 1}, .zero = {1, 0, 0}, .quarter = {0, 1, 0}};
    addCap(surface, facing, {.along = z, .radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 1, 0}},
           rings, unitCircle(slices));
    return std::move(surface).finish();
}

}  // namespace glibra::geometry
