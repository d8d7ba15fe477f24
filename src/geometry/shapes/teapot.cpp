#include "geometry/shapes/teapot.h"

#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

/// A control point of a profile that is turned around the z axis. `pull` is the distance of the two inner
/// control points of a quarter circle from its ends, .56 of the radius except at the knob.
struct ProfilePoint {
    double radius = 0, z = 0;
    double pull = .56;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kBottom{{{0, 0}, {1.425, 0}, {1.5, .075}, {1.5, .15}}};
constexpr Profile kLowerBody{{{1.5, .15}, {1.5, .225}, {2, .45}, {2, .9}}};
constexpr Profile kUpperBody{{{2, .9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}};
constexpr Profile kRim{{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}};
constexpr Profile kLid{{{1.3, 2.4}, {1.3, 2.55}, {.4, 2.55}, {.2, 2.7}}};
constexpr Profile kKnob{{{.2, 2.7}, {0, 2.85}, {.8, 3.15, .5625}, {0, 3.15}}};

/// One cross-section of handle or spout: half of a closed curve, through y <= 0, with both ends in the plane
/// y = 0.
struct Section {
    double x0 = 0, z0 = 0;  ///< the first two control points
    double x1 = 0, z1 = 0;  ///< the last two
    double width = 0;       ///< |y| of the inner two; the outer two are at y = 0
};
using Sections = std::array<Section, 4>;

constexpr Sections kUpperHandle{{{-1.6, 2.025, -1.5, 2.25, .3},
                                 {-2.3, 2.025, -2.5, 2.25, .3},
                                 {-2.7, 2.025, -3, 2.25, .3},
                                 {-2.7, 1.8, -3, 1.8, .3}}};
constexpr Sections kLowerHandle{{{-2.7, 1.8, -3, 1.8, .3},
                                 {-2.7, 1.575, -3, 1.35, .3},
                                 {-2.5, 1.125, -2.65, .9375, .3},
                                 {-2, .9, -1.9, .6, .3}}};
constexpr Sections kLowerSpout{{{1.7, 1.425, 1.7, .6, .66},
                                {2.6, 1.425, 3.1, .825, .66},
                                {2.3, 2.1, 2.4, 2.025, .25},
                                {2.7, 2.4, 3.3, 2.4, .25}}};
constexpr Sections kUpperSpout{{{2.7, 2.4, 3.3, 2.4, .25},
                                {2.8, 2.475, 3.525, 2.49375, .25},
                                {2.9, 2.475, 3.45, 2.5125, .15},
                                {2.8, 2.4, 3.2, 2.4, .15}}};

/// A quarter of the turned profile, counter-clockwise from above, beginning `quarter` quarter turns after +x.
Patch turned(const Profile& profile, int quarter) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [radius, z, pull] = profile[row];
        const double off = pull * radius;
        patch[row] = {{{radius, 0, z}, {radius, off, z}, {off, radius, z}, {0, radius, z}}};
        for (glm::dvec3& point : patch[row])
            for (int turn = 0; turn < quarter; ++turn) point = {-point.y, point.x, point.z};
    }
    return patch;
}

Patch nearHalf(const Sections& sections) {
    Patch patch;
    for (std::size_t row = 0; row < 4; ++row) {
        const auto [x0, z0, x1, z1, width] = sections[row];
        patch[row] = {{{x0, 0, z0}, {x0, -width, z0}, {x1, -width, z1}, {x1, 0, z1}}};
    }
    return patch;
}

/// The other half, y >= 0, which continues where the near half ends.
Patch farHalf(const Sections& sections) {
    Patch patch = nearHalf(sections);
    for (auto& row : patch) {
        row = {row[3], row[2], row[1], row[0]};
        for (glm::dvec3& point : row) point.y = -point.y;
    }
    return patch;
}

}  // namespace

std::array<Patch, 32> teapotPatches() {
    std::array<Patch, 32> patches;
    std::size_t next = 0;
    for (const Profile& profile : {kRim, kUpperBody, kLowerBody, kKnob, kLid, kBottom})
        // The published order goes clockwise from the quarter between +x and -y.
        for (int quarter = 3; quarter >= 0; --quarter) patches[next++] = turned(profile, quarter);
    for (const Sections& sections : {kUpperHandle, kLowerHandle, kLowerSpout, kUpperSpout}) {
        patches[next++] = nearHalf(sections);
        patches[next++] = farHalf(sections);
    }
    return patches;
}

namespace {

using Weights = std::array<double, 4>;

/// Cubic Bernstein polynomials. At 0 and 1 the weighted sum is an end point, bit for bit.
Weights bernstein(double u) {
    const double w = 1 - u;
    return {w * w * w, 3 * u * w * w, 3 * u * u * w, u * u * u};
}

Weights bernsteinDerivative(double u) {
    const double w = 1 - u;
    return {-3 * w * w, 3 * w * w - 6 * u * w, 6 * u * w - 3 * u * u, 3 * u * u};
}

glm::dvec3 weighted(const Weights& weights, const std::array<glm::dvec3, 4>& points) {
    return weights[0] * points[0] + weights[1] * points[1] + weights[2] * points[2] + weights[3] * points[3];
}

bool isOnePoint(const std::array<glm::dvec3, 4>& row) {
    return row[0] == row[1] && row[1] == row[2] && row[2] == row[3];
}

/// Rows are reduced first, so that patches that share a row or a column of control points also share the
/// curve.
SurfacePoint evaluate(const Patch& patch, double s, double t) {
    std::array<glm::dvec3, 4> points, slopes;
    for (std::size_t row = 0; row < 4; ++row) {
        points[row] = isOnePoint(patch[row]) ? patch[row][0] : weighted(bernstein(s), patch[row]);
        slopes[row] = isOnePoint(patch[row]) ? glm::dvec3(0) : weighted(bernsteinDerivative(s), patch[row]);
    }
    const glm::dvec3 alongS = weighted(bernstein(t), slopes),
                     alongT = weighted(bernsteinDerivative(t), points);
    // dP/ds is zero only at the two poles, where the profile is level.
    const glm::dvec3 pole{0, t == 0 ? -1 : 1, 0};
    return {.position = weighted(bernstein(t), points),
            .normal = unitOr(glm::cross(alongS, alongT), pole),
            .tangent = unitOr(alongT, pole),
            .texCoord = {s, t, 0}};
}

bool beginsInPoint(const Patch& patch) {
    return isOnePoint(patch.front());
}
bool endsInPoint(const Patch& patch) {
    return isOnePoint(patch.back());
}

std::array<Patch, 32> uprightPatches() {
    std::array<Patch, 32> patches = teapotPatches();
    for (Patch& patch : patches)
        for (auto& row : patch)
            for (glm::dvec3& point : row) point = teapotPlace(point);
    return patches;
}

void addPatchPoints(Surface& surface, const Patch& patch, int cells) {
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i)
            surface.add(evaluate(patch, static_cast<double>(i) / cells, static_cast<double>(j) / cells));
}

}  // namespace

glm::dvec3 teapotPlace(const glm::dvec3& original) {
    return {.5 * original.x, .5 * (original.z - 1.5), -.5 * original.y};
}

Mesh teapot(int cells) {
    assert(cells >= 2);
    const auto columns = static_cast<std::uint32_t>(cells), stride = columns + 1;
    Surface surface(Topology::triangles, 2, teapotCounts(cells));
    for (const Patch& patch : uprightPatches()) {
        std::uint32_t row = surface.size();
        addPatchPoints(surface, patch, cells);
        std::uint32_t rows = columns;
        if (beginsInPoint(patch)) {
            for (std::uint32_t i = row; i < row + columns; ++i)
                surface.triangle(i, i + stride + 1, i + stride);
            row += stride;
            --rows;
        }
        if (endsInPoint(patch)) --rows;
        surface.gridCells(row, columns, rows);
        row += rows * stride;
        if (endsInPoint(patch))
            for (std::uint32_t i = row; i < row + columns; ++i) surface.triangle(i, i + 1, i + stride);
    }
    return std::move(surface).finish();
}

Mesh wireTeapot() {
    constexpr std::uint32_t kCells = 8;
    Surface surface(Topology::lines, 2, wireTeapotCounts());
    for (const Patch& patch : uprightPatches()) {
        const std::uint32_t base = surface.size();
        addPatchPoints(surface, patch, kCells);
        addGridEdges(surface, base,
                     {.columns = kCells,
                      .rows = kCells,
                      .firstRow = beginsInPoint(patch) ? 1U : 0U,
                      .endRow = endsInPoint(patch) ? kCells : kCells + 1,
                      .endColumn = kCells + 1});
    }
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kTeapotArguments[] = {countArgument("cells", 16, 2, 16)};

/// Patches that meet need the same number of cells along the seam, so the most bent ones, those of the spout,
/// decide for all. The theorem's bound would be 1.41 / cells^2; the factors here are those measured on meshes
/// of 2 to 48 cells, where they rise to 1.07 and 0.805.
double teapotDeviation(Numbers n, Fidelity fidelity) {
    return (fidelity == Fidelity::shape ? .81 : 1.1) / (n[0] * n[0]);
}

Extent teapotExtent(Numbers) {
    glm::dvec3 low(1e9), high(-1e9);
    for (const Patch& patch : teapotPatches())
        for (const auto& row : patch)
            for (const glm::dvec3& point : row) {
                low = glm::min(low, teapotPlace(point));
                high = glm::max(high, teapotPlace(point));
            }
    return boxExtent(low, high);
}

}  // namespace

constexpr PrimitiveSpec kTeapotRow{.names = {"Teapot"},
                                   .arguments = kTeapotArguments,
                                   .summary = "the classic teapot",
                                   .counts = [](Numbers n) { return teapotCounts(countAt(n, 0)); },
                                   .make = [](Numbers n) { return teapot(countAt(n, 0)); },
                                   .twin = &kWireTeapotRow,
                                   .deviation = teapotDeviation,
                                   .extent = teapotExtent};

constexpr PrimitiveSpec kWireTeapotRow{.names = {"WireTeapot"},
                                       .summary = "the teapot as lines",
                                       .topology = Topology::lines,
                                       .counts = [](Numbers) { return wireTeapotCounts(); },
                                       .make = [](Numbers) { return wireTeapot(); },
                                       .twin = &kTeapotRow};

}  // namespace glibra::geometry
