#include "geometry/shapes/flat.h"

#include <glm/geometric.hpp>

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

constexpr ShapeArgument kPlaneArguments[] = {sizeArgument("size", 1), numberArgument("s repeats", 1),
                                             numberArgument("t repeats", 1), countArgument("nx", 4, 1),
                                             countArgument("nz", 4, 1)};

}  // namespace

Mesh plane(double size, double sRepeats, double tRepeats, int nx, int nz) {
    assert(size >= 0 && nx >= 1 && nz >= 1);
    Surface surface(Topology::triangles, 2, planeCounts(nx, nz));
    for (int j = 0; j <= nz; ++j)
        for (int i = 0; i <= nx; ++i) {
            const double a = static_cast<double>(i) / nx, b = static_cast<double>(j) / nz;
            surface.add({.position = {(2 * a - 1) * size, 0, (1 - 2 * b) * size},
                         .normal = {0, 1, 0},
                         .tangent = {0, 0, tRepeats < 0 ? 1 : -1},
                         .texCoord = {sRepeats * a, tRepeats * b, 0}});
        }
    surface.gridCells(0, static_cast<std::uint32_t>(nx), static_cast<std::uint32_t>(nz));
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kPlaneRow{
    .names = {"Plane"},
    .arguments = kPlaneArguments,
    .summary = "square -size..size at y = 0 on which a texture repeats",
    .counts = [](Numbers n) { return planeCounts(countAt(n, 3), countAt(n, 4)); },
    .make = [](Numbers n) { return plane(n[0], n[1], n[2], countAt(n, 3), countAt(n, 4)); },
    .deviation = [](Numbers, Fidelity) { return 0.; },
    .extent = [](Numbers) { return Extent{}; }};

Mesh diskXY(double z, double radius, int slices, int rings) {
    assert(radius >= 0 && slices >= 3 && rings >= 1);
    Surface surface(Topology::triangles, 2, diskXYCounts(slices, rings));
    const Axis facing{.along = {0, 0, 1}, .zero = {1, 0, 0}, .quarter = {0, 1, 0}};
    addCap(surface, facing, {.along = z, .radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 1, 0}},
           rings, unitCircle(slices));
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kDiskArguments[] = {numberArgument("z", 0), sizeArgument("radius", 1),
                                            countArgument("slices", 60, 3, kSmoothTurn),
                                            countArgument("rings", 10, 1)};

}  // namespace

constexpr PrimitiveSpec kDiskXYRow{
    .names = {"DiskXY"},
    .arguments = kDiskArguments,
    .summary = "disk parallel to XY",
    .counts = [](Numbers n) { return diskXYCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return diskXY(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    // s and t are linear in x and y, so only the rim is off.
    .deviation = [](Numbers n, Fidelity) { return chordDeviation(n[1], n[2]); },
    .extent = [](Numbers n) { return boxExtent({-n[1], -n[1], n[0]}, {n[1], n[1], n[0]}); }};

namespace {

/// A square through `centre`. Cells run along `right`, rows along `up`. mirrorS and mirrorT change only the
/// texture coordinates and the tangent.
struct Square {
    glm::dvec3 centre, right, up;
    bool mirrorS = false, mirrorT = false;
};

Mesh square(const Square& shape, double size, int columns, int rows) {
    assert(size >= 0 && columns >= 1 && rows >= 1);
    Surface surface(Topology::triangles, 2, quadCounts(columns, rows));
    const glm::dvec3 normal = glm::cross(shape.right, shape.up);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const double a = static_cast<double>(i) / columns, b = static_cast<double>(j) / rows;
            surface.add({.position = shape.centre + shape.right * ((2 * a - 1) * size) +
                                     shape.up * ((2 * b - 1) * size),
                         .normal = normal,
                         .tangent = shape.mirrorT ? -shape.up : shape.up,
                         .texCoord = {shape.mirrorS ? 1 - a : a, shape.mirrorT ? 1 - b : b, 0}});
        }
    surface.gridCells(0, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    return std::move(surface).finish();
}

}  // namespace

Mesh quadXY(double z, double size, int nx, int ny) {
    return square({{0, 0, z}, {1, 0, 0}, {0, 1, 0}, z < 0, false}, size, nx, ny);
}

Mesh quadXZ(double y, double size, int nx, int nz) {
    return square({{0, y, 0}, {1, 0, 0}, {0, 0, -1}, false, y < 0}, size, nx, nz);
}

Mesh quadYZ(double x, double size, int ny, int nz) {
    return square({{x, 0, 0}, {0, 0, -1}, {0, 1, 0}, x < 0, false}, size, nz, ny);
}

Mesh quadBox(int n) {
    assert(n >= 1);
    Surface surface(Topology::triangles, 3, quadBoxCounts(n));
    for (int i = 0; i < n; ++i) {
        const double p = n == 1 ? .5 : static_cast<double>(i) / (n - 1);
        const std::uint32_t base = surface.size();
        for (const double t : {0., 1.})
            for (const double s : {0., 1.}) {
                const glm::dvec3 texCoord{s, t, p};
                surface.add({.position = 2.0 * texCoord - 1.0, .texCoord = texCoord});
            }
        surface.gridCells(base, 1, 1);
    }
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kSize = sizeArgument("size", 1);
constexpr ShapeArgument kCellsAlongX = countArgument("nx", 4, 1), kCellsAlongY = countArgument("ny", 4, 1),
                        kCellsAlongZ = countArgument("nz", 4, 1);
constexpr ShapeArgument kXYArguments[] = {numberArgument("z", 0), kSize, kCellsAlongX, kCellsAlongY};
constexpr ShapeArgument kXZArguments[] = {numberArgument("y", 0), kSize, kCellsAlongX, kCellsAlongZ};
constexpr ShapeArgument kYZArguments[] = {numberArgument("x", 0), kSize, kCellsAlongY, kCellsAlongZ};
constexpr ShapeArgument kBoxArguments[] = {
    countArgument("quads", 10, 1, kAsGiven, static_cast<int>(kMostVertices / 4))};

}  // namespace

constexpr PrimitiveSpec kQuadXYRow{
    .names = {"QuadXY"},
    .arguments = kXYArguments,
    .summary = "square -size..size parallel to XY",
    .counts = [](Numbers n) { return quadCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return quadXY(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .deviation = [](Numbers, Fidelity) { return 0.; },
    .extent = [](Numbers) { return Extent{}; }};

constexpr PrimitiveSpec kQuadXZRow{
    .names = {"QuadXZ"},
    .arguments = kXZArguments,
    .summary = "square -size..size parallel to XZ",
    .counts = [](Numbers n) { return quadCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return quadXZ(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .deviation = [](Numbers, Fidelity) { return 0.; },
    .extent = [](Numbers) { return Extent{}; }};

constexpr PrimitiveSpec kQuadYZRow{
    .names = {"QuadYZ"},
    .arguments = kYZArguments,
    .summary = "square -size..size parallel to YZ",
    .counts = [](Numbers n) { return quadCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return quadYZ(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .deviation = [](Numbers, Fidelity) { return 0.; },
    .extent = [](Numbers) { return Extent{}; }};

constexpr PrimitiveSpec kQuadBoxRow{.names = {"QuadBox"},
                                    .arguments = kBoxArguments,
                                    .summary = "stack of squares filling -1..1",
                                    .counts = [](Numbers n) { return quadBoxCounts(countAt(n, 0)); },
                                    .make = [](Numbers n) { return quadBox(countAt(n, 0)); }};

constexpr PrimitiveSpec kFullScreenRow{.names = {"FullScreen"},
                                       .summary = "rectangle that covers the screen, whatever the view",
                                       .space = Space::clip,
                                       .counts = [](Numbers) { return quadCounts(1, 1); },
                                       .make = [](Numbers) { return quadXY(0, 1, 1, 1); }};

}  // namespace glibra::geometry
