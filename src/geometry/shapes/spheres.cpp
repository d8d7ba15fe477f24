#include "geometry/shapes/spheres.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

// Parts of spheres: the rings and poles of which spheres, half spheres and capsules consist.

/// One ring, or one pole, of a ball around the y axis.
struct BallRing {
    glm::dvec2 latitude{1, 0};  ///< (cos f, sin f)
    double t = 0;
    double centre = 0;  ///< y of the ball's centre
};

SurfacePoint ballPoint(double radius, const BallRing& ring, const glm::dvec2& around, double s) {
    const double c = ring.latitude.x, y = ring.latitude.y;
    const glm::dvec3 normal{-around.x * c, y, around.y * c};
    return {.position = radius * normal + glm::dvec3(0, ring.centre, 0),
            .normal = normal,
            .tangent = {around.x * y, c, -around.y * y},
            .texCoord = {s, ring.t, 0}};
}

/// Adds a pole: one vertex per slice, with s in the slice's middle.
void addBallPole(Surface& surface, double radius, const BallRing& pole, int slices) {
    for (int i = 0; i < slices; ++i)
        surface.add(ballPoint(radius, pole, unitTurn(2 * std::int64_t{i} + 1, 2 * std::int64_t{slices}),
                              (i + .5) / slices));
}

/// Adds the vertices of a ring: P = radius (-cos 2 pi s cos f, sin f, sin 2 pi s cos f) from the centre.
/// `circle` is unitCircle(slices).
void addBallRing(Surface& surface, double radius, const BallRing& ring, std::span<const glm::dvec2> circle) {
    const auto slices = static_cast<double>(circle.size() - 1);
    for (std::size_t i = 0; i < circle.size(); ++i)
        surface.add(ballPoint(radius, ring, circle[i], static_cast<double>(i) / slices));
}

void addSpherePoints(Surface& surface, double radius, int slices, int stacks) {
    assert(radius >= 0 && slices >= 3 && stacks >= 2);
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    addBallPole(surface, radius, {{0, -1}, 0}, slices);
    for (int j = 1; j < stacks; ++j) {
        const glm::dvec2 colatitude = unitTurn(j, 2 * std::int64_t{stacks});  // from the south pole
        addBallRing(surface, radius, {{colatitude.y, -colatitude.x}, static_cast<double>(j) / stacks},
                    circle);
    }
    addBallPole(surface, radius, {{0, 1}, 1}, slices);
}

}  // namespace

/// Adds the triangles between a ring and the pole north of it; each is the number of its first vertex.
static void addNorthCells(Surface& surface, std::uint32_t ring, std::uint32_t pole, std::uint32_t slices) {
    for (std::uint32_t i = 0; i < slices; ++i) surface.triangle(ring + i, ring + i + 1, pole + i);
}

/// Adds the triangles of a closed ball whose vertices begin at 0: the south pole, `rings` rings, the north
/// pole.
static void addBallCells(Surface& surface, std::uint32_t rings, std::uint32_t slices) {
    const std::uint32_t lastRing = slices + (rings - 1) * (slices + 1);
    for (std::uint32_t i = 0; i < slices; ++i) surface.triangle(i, slices + i + 1, slices + i);
    surface.gridCells(slices, slices, rings - 1);
    addNorthCells(surface, lastRing, lastRing + slices + 1, slices);
}

Mesh sphere(double radius, int slices, int stacks) {
    Surface surface(Topology::triangles, 2, sphereCounts(slices, stacks));
    addSpherePoints(surface, radius, slices, stacks);
    addBallCells(surface, static_cast<std::uint32_t>(stacks) - 1, static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

Mesh wireSphere(double radius, int slices, int stacks) {
    Surface surface(Topology::lines, 2, wireSphereCounts(slices, stacks));
    addSpherePoints(surface, radius, slices, stacks);
    const auto a = static_cast<std::uint32_t>(slices), b = static_cast<std::uint32_t>(stacks);
    const std::uint32_t lastRing = a + (b - 2) * (a + 1), north = lastRing + a + 1;
    for (std::uint32_t i = 0; i < a; ++i) surface.segment(i, a + i);
    addGridEdges(surface, a, {.columns = a, .rows = b - 2, .endRow = b - 1, .endColumn = a});
    for (std::uint32_t i = 0; i < a; ++i) surface.segment(lastRing + i, north + i);
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kSphereArguments[] = {sizeArgument("radius", 1),
                                              countArgument("slices", 60, 3, kSmoothTurn),
                                              countArgument("stacks", 60, 2, kSmoothTurn / 2)};
constexpr ShapeArgument kWireSphereArguments[] = {sizeArgument("radius", 1), countArgument("slices", 20, 3),
                                                  countArgument("stacks", 20, 2)};

double sphereDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[1], std::numbers::pi / n[2], fidelity);
}

}  // namespace

constexpr PrimitiveSpec kSphereRow{
    .names = {"Sphere"},
    .arguments = kSphereArguments,
    .summary = "sphere, poles on the y axis",
    .counts = [](Numbers n) { return sphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return sphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .isClosed = true,
    .twin = &kWireSphereRow,
    .deviation = sphereDeviation,
    .extent = [](Numbers n) { return ballExtent(n[0]); }};

constexpr PrimitiveSpec kWireSphereRow{
    .names = {"WireSphere"},
    .arguments = kWireSphereArguments,
    .summary = "sphere as lines",
    .topology = Topology::lines,
    .counts = [](Numbers n) { return wireSphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return wireSphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .twin = &kSphereRow};

namespace {

constexpr ShapeArgument kHalfSphereArguments[] = {sizeArgument("radius", 1),
                                                  countArgument("slices", 60, 3, kSmoothTurn),
                                                  countArgument("stacks", 30, 1, kSmoothTurn / 4)};

double halfSphereDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[1], std::numbers::pi / 2 / n[2], fidelity);
}

}  // namespace

Mesh halfSphere(double radius, int slices, int stacks) {
    assert(radius >= 0 && slices >= 3 && stacks >= 1);
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    Surface surface(Topology::triangles, 2, halfSphereCounts(slices, stacks));
    for (int j = 0; j < stacks; ++j)
        addBallRing(surface, radius, {unitTurn(j, 4 * std::int64_t{stacks}), static_cast<double>(j) / stacks},
                    circle);
    const std::uint32_t pole = surface.size();
    addBallPole(surface, radius, {{0, 1}, 1}, slices);
    const auto a = static_cast<std::uint32_t>(slices);
    surface.gridCells(0, a, static_cast<std::uint32_t>(stacks) - 1);
    addNorthCells(surface, pole - (a + 1), pole, a);
    addCap(surface, kStanding, {.radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 0, 1}}, 1,
           circle);
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kHalfSphereRow{
    .names = {"HalfSphere"},
    .arguments = kHalfSphereArguments,
    .summary = "upper half of a sphere, closed by a disk at y = 0",
    .counts = [](Numbers n) { return halfSphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return halfSphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .isClosed = true,
    .deviation = halfSphereDeviation,
    .extent = [](Numbers n) { return standingExtent(n[0], n[0]); }};

namespace {}  // namespace

namespace {

constexpr ShapeArgument kCapsuleArguments[] = {sizeArgument("radius", .5), sizeArgument("height", 1),
                                               countArgument("slices", 60, 3, kSmoothTurn),
                                               countArgument("stacks", 20, 1, kSmoothTurn / 4)};

/// The half spheres are off by more than the cylinder.
double capsuleDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[2], std::numbers::pi / 2 / n[3], fidelity);
}

Extent capsuleExtent(Numbers n) {
    const double end = n[0] + n[1] / 2;
    return {{-n[0], -end, -n[0]}, {n[0], end, n[0]}, end};
}

}  // namespace

Mesh capsule(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    const double quarter = std::numbers::pi / 2 * radius, length = 2 * quarter + height;
    const auto t = [&](double along) { return length > 0 ? along / length : 0; };
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    Surface surface(Topology::triangles, 2, capsuleCounts(slices, stacks));
    addBallPole(surface, radius, {{0, -1}, 0, -height / 2}, slices);
    for (int half = 0; half < 2; ++half)
        for (int j = 0; j < stacks; ++j) {
            // Counted from the pole in the south, from the equator in the north.
            const int row = half == 0 ? j + 1 : j;
            const glm::dvec2 turn = unitTurn(row, 4 * std::int64_t{stacks});
            const double part = static_cast<double>(row) / stacks;
            const BallRing ring = half == 0
                                      ? BallRing{{turn.y, -turn.x}, t(quarter * part), -height / 2}
                                      : BallRing{turn, t(quarter + height + quarter * part), height / 2};
            addBallRing(surface, radius, ring, circle);
        }
    addBallPole(surface, radius, {{0, 1}, 1, height / 2}, slices);
    addBallCells(surface, 2 * static_cast<std::uint32_t>(stacks), static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kCapsuleRow{
    .names = {"Capsule"},
    .arguments = kCapsuleArguments,
    .summary = "cylinder with a half sphere at each end, centred; height is the cylinder's",
    .counts = [](Numbers n) { return capsuleCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return capsule(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .isClosed = true,
    .deviation = capsuleDeviation,
    .extent = capsuleExtent};

}  // namespace glibra::geometry
