#include "geometry/shapes/quads.h"

#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/shapes/surface.h"

namespace glibra::geometry {
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
