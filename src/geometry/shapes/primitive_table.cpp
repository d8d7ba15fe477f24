// The list of all primitives, and what holds for all of them.

#include <algorithm>
#include <cmath>

#include "geometry/shapes/clouds.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/flat.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/primitive.h"
#include "geometry/shapes/spheres.h"
#include "geometry/shapes/teapot.h"

namespace glibra::geometry {
namespace {

// clang-format off
constexpr const PrimitiveSpec* kPrimitives[] = {
    &kBoxRow,
    &kSphereRow,
    &kCylinderRow,
    &kConeRow,
    &kTorusRow,
    &kTeapotRow,
    &kSoccerballRow,
    &kDiskXYRow,
    &kQuadXYRow,
    &kQuadXZRow,
    &kQuadYZRow,
    &kQuadBoxRow,
    &kXarrowRow,
    &kPointCloudRow,
    &kJitterCloudRow,
    &kWireSphereRow,
    &kWireTorusRow,
    &kWireCylinderRow,
    &kWireConeRow,
    &kWireCubeRow,
    &kWireBoxRow,
    &kWireTeapotRow,
    &kCapsuleRow,
    &kPyramidRow,
    &kTetrahedronRow,
    &kHalfSphereRow,
    &kPlaneRow,
    &kFullScreenRow,
    &kSkyBoxRow,
};
// clang-format on

double complete(const ShapeArgument& argument, double given) {
    switch (argument.kind) {
        case ArgumentKind::number:
            break;
        case ArgumentKind::size:
            return std::abs(given);
        case ArgumentKind::count:
            return std::trunc(std::clamp(given, argument.least, static_cast<double>(kMostVertices)));
        case ArgumentKind::seed:
            return std::trunc(std::clamp(given, argument.least, argument.most));
    }
    return given;
}

}  // namespace

std::span<const PrimitiveSpec* const> primitives() {
    return kPrimitives;
}

std::vector<double> completeNumbers(const PrimitiveSpec& spec, Numbers given) {
    std::vector<double> numbers;
    numbers.reserve(spec.arguments.size());
    for (const ShapeArgument& each : spec.arguments)
        numbers.push_back(numbers.size() < given.size() ? complete(each, given[numbers.size()])
                                                        : each.byDefault);
    return numbers;
}

bool drawsNothing(const PrimitiveSpec& spec, Numbers given) {
    const std::vector<double> numbers = completeNumbers(spec, given);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (spec.arguments[i].kind == ArgumentKind::size && numbers[i] == 0) return true;
    return false;
}

}  // namespace glibra::geometry
