// Two kinds of bound.
//
// `shape`: a chord of a circle with radius r, cut into n, lies r (1 - cos(pi/n)) inside it.
// `pattern`: on a triangle that spans ds, dt of the parameters, linear interpolation is off by no more than
// (ds^2 |P_ss| + 2 ds dt |P_st| + dt^2 |P_tt|) / 8 (Filip, Magedson, Markot: Surface algorithms using bounds
// on derivatives, Computer Aided Geometric Design 3, 1986, theorem 1). It is larger than the first where
// cells are twisted: the diagonals of a sphere's cells shear what is painted on them.

#include "budget/surface_model.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/shapes/arrow.h"
#include "geometry/shapes/teapot.h"
#include "geometry/shapes/teapot_patches.h"

namespace glibra::budget {
namespace {

using glib::CommandId;
using Numbers = std::span<const double>;
constexpr double kPi = std::numbers::pi;

/// A cell of 10 degrees: diffuse light, a cosine, is off by (pi/18)^2 / 8 = 0.97/255 where it is
/// interpolated.
constexpr int kSmoothTurn = 36;

double chord(double radius, double slices) {
    return radius * (1 - std::cos(kPi / slices));
}

Bounds box(const glm::dvec3& low, const glm::dvec3& high) {
    return {low, high, glm::length(high - low) / 2};
}
Bounds ball(double radius) {
    return {glm::dvec3(-radius), glm::dvec3(radius), radius};
}
Bounds nowhere(Numbers) {
    return {};
}
double exact(Numbers, Fidelity) {
    return 0;
}

/// The quads of a row of cells are planar, and the planes of the row at the equator, or next to it, are the
/// furthest inside: R cos(pi/slices) cos(pi/(2 stacks)) from the centre if the row straddles the equator.
double sphereDeviation(Numbers n, Fidelity fidelity) {
    const double around = 2 * kPi / n[1], along = kPi / n[2];
    if (fidelity == Fidelity::shape) return n[0] * (1 - std::cos(around / 2) * std::cos(along / 2));
    // |P_ss| = cos f, |P_sf| = |sin f|, |P_ff| = 1 at the latitude f: the largest sum over f.
    const double square = around * around;
    return n[0] / 8 * (along * along + std::hypot(square, 2 * around * along));
}

double cylinderDeviation(Numbers n, Fidelity fidelity) {
    const double around = 2 * kPi / n[2];
    return fidelity == Fidelity::shape ? chord(n[0], n[2]) : n[0] * around * around / 8;
}

/// Of a cone's side: the rows narrow toward the apex, which twists the cells.
double coneSide(double radius, double slices, double stacks, Fidelity fidelity) {
    const double around = 2 * kPi / slices;
    return fidelity == Fidelity::shape ? chord(radius, slices)
                                       : radius / 8 * (around * around + 2 * around / stacks);
}

double torusDeviation(Numbers n, Fidelity fidelity) {
    const double ring = std::max(n[0], n[1]), tube = std::min(n[0], n[1]);
    if (fidelity == Fidelity::shape) return chord(tube, n[2]) + chord(ring + tube, n[3]);
    // |P_uu| = R + r cos v, |P_uv| = r |sin v|, |P_vv| = r: the largest sum over v.
    const double u = 2 * kPi / n[3], v = 2 * kPi / n[2];
    return (ring * u * u + tube * v * v + std::hypot(tube * u * u, 2 * tube * u * v)) / 8;
}

double diskDeviation(Numbers n, Fidelity) {
    return chord(n[1], n[2]);  // s and t are linear in x and y
}

double arrowDeviation(Numbers n, Fidelity fidelity) {
    const double onHead = n[0] - geometry::xarrowShaftSlices(static_cast<int>(n[0]));
    return coneSide(.1, n[1], onHead, fidelity);
}

/// The middle of a hexagon is pushed out furthest, by 1/d, d its distance in radii: the small triangles there
/// have the side e / (d cuts), e the edge of the truncated icosahedron, and the circumradius q, and lie
/// 1 - sqrt(1 - q^2) <= q^2 / (1 + sqrt(1 - q^2)) inside. Measured, the pattern moves by less than 2.2 of
/// that.
double soccerballDeviation(Numbers n, Fidelity fidelity) {
    constexpr double kEdge = .403548, kDistance = .914958;
    const double circumradius = std::min(1., kEdge / (kDistance * n[1] * std::numbers::sqrt3));
    const double inside = 1 - std::sqrt(1 - circumradius * circumradius);
    return n[0] * inside * (fidelity == Fidelity::shape ? 1 : 2.2);
}

/// Patches that meet need the same number of cells along the seam, so the most bent ones, of the spout,
/// decide for all. The theorem's bound would be 1.41 / cells^2; the factors here are those measured on meshes
/// of 2 to 48 cells, where they rise to 1.07 and 0.805.
double teapotDeviation(Numbers n, Fidelity fidelity) {
    return (fidelity == Fidelity::shape ? .81 : 1.1) / (n[0] * n[0]);
}

Bounds teapotBounds(Numbers) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const geometry::Patch& patch : geometry::teapotPatches())
        for (const auto& row : patch)
            for (const glm::dvec3& point : row) {
                low = glm::min(low, geometry::teapotPlace(point));
                high = glm::max(high, geometry::teapotPlace(point));
            }
    return box(low, high);
}

Bounds standing(Numbers n) {
    return box({-n[0], 0, -n[0]}, {n[0], n[1], n[0]});
}
Bounds torusBounds(Numbers n) {
    const double tube = std::min(n[0], n[1]), all = n[0] + n[1];
    return {{-all, -all, -tube}, {all, all, tube}, all};
}
Bounds diskBounds(Numbers n) {
    return box({-n[1], -n[1], n[0]}, {n[1], n[1], n[0]});
}

constexpr int kSmoothHalf = kSmoothTurn / 2;
constexpr CountArgument kStraight2{2, 1, kAsGiven}, kStraight3{3, 1, kAsGiven};

constexpr SurfaceModel kModels[] = {
    {CommandId::sphere,
     {{{1, 3, kSmoothTurn}, {2, 2, kSmoothHalf}}},
     2,
     [](Numbers n) { return ball(n[0]); },
     sphereDeviation},
    {CommandId::cylinder, {{{2, 3, kSmoothTurn}, kStraight3}}, 2, standing, cylinderDeviation},
    {CommandId::cone,
     {{{2, 3, kSmoothTurn}, kStraight3}},
     2,
     standing,
     [](Numbers n, Fidelity fidelity) { return coneSide(n[0], n[2], n[3], fidelity); }},
    // The language's 20 sides are fewer than a smooth turn; 36 would be more than it asks for.
    {CommandId::torus, {{{2, 3, 20}, {3, 3, kSmoothTurn}}}, 2, torusBounds, torusDeviation},
    {CommandId::diskXY, {{{2, 3, kSmoothTurn}, kStraight3}}, 2, diskBounds, diskDeviation},
    {CommandId::quadXY, {{kStraight2, kStraight3}}, 2, nowhere, exact},
    {CommandId::quadXZ, {{kStraight2, kStraight3}}, 2, nowhere, exact},
    {CommandId::quadYZ, {{kStraight2, kStraight3}}, 2, nowhere, exact},
    {CommandId::teapot, {{{0, 2, 16, 16}}}, 1, teapotBounds, teapotDeviation},
    {CommandId::soccerball, {{{1, 1, 3, 8}}}, 1, [](Numbers n) { return ball(n[0]); }, soccerballDeviation},
    {CommandId::xarrow,
     {{{0, 2, kAsGiven}, {1, 3, 24, 24}}},
     2,
     [](Numbers) {
         return box({-1, -.1, -.1}, {1, .1, .1});
     },
     arrowDeviation},
};

}  // namespace

std::vector<double> SurfaceModel::complete(const scene::Shape& shape) const {
    std::vector<double> numbers = shape.numbers;
    for (const CountArgument& each : usedCounts())
        if (each.index == numbers.size()) numbers.push_back(each.byDefault);
    return numbers;
}

const SurfaceModel* surfaceModel(glib::CommandId command) {
    const auto* const row = std::find_if(std::begin(kModels), std::end(kModels),
                                         [&](const SurfaceModel& each) { return each.command == command; });
    return row == std::end(kModels) ? nullptr : row;
}

}  // namespace glibra::budget
