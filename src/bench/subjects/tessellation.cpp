#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/tessellator.h"
#include "bench/reference/bezier_surface.h"
#include "bench/reference/pn_triangle.h"
#include "bench/subjects/subjects.h"
#include "bench/subjects/tessellation_cracks.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

constexpr int kCells = 4;  // distances are taken at 15 points of each triangle
constexpr double kFitFrom = 8;
constexpr int kPicture = 256;

/// A surface, and the distance of a point from it.
struct Analytic {
    std::string_view name, title, unit, reference;
    Evaluation evaluation = Evaluation::bernstein;
    std::vector<glm::vec3> points{};
    /// Computed in double; `coordinate` is close to the coordinate of the nearest point.
    std::function<double(const glm::dvec3& point, const glm::dvec3& coordinate)> distance{};
    /// The point that belongs to a coordinate.
    std::function<glm::dvec3(const glm::dvec3& coordinate)> at{};
};

Analytic bezierPatch() {
    const geometry::Patch patch = geometry::teapotPatches()[geometry::kTeapotSpout];
    std::vector<glm::vec3> points;
    geometry::Patch rounded;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            points.emplace_back(patch[row][column]);
            rounded[row][column] = glm::dvec3(points.back());
        }
    return {
        .name = "bezier",
        .title = "A bicubic patch (the teapot's spout)",
        .unit = "teapot units",
        .reference =
            "the nearest point of the patch in double, by de Casteljau's algorithm and Gauss-Newton "
            "steps",
        .evaluation = Evaluation::bernstein,
        .points = std::move(points),
        .distance =
            [rounded](const glm::dvec3& point, const glm::dvec3& coordinate) {
                const glm::dvec2 st = nearestOnPatch(rounded, point, coordinate);
                return glm::length(point - patchPoint(rounded, st).position);
            },
        .at = [rounded](const glm::dvec3& coordinate) { return patchPoint(rounded, coordinate).position; }};
}

Analytic sphereOctant() {
    return {.name = "sphere",
            .title = "An octant of a sphere",
            .unit = "radii",
            .reference = "the distance from the centre, which is 1 on the sphere, in double",
            .evaluation = Evaluation::sphereOctant,
            .distance = [](const glm::dvec3& point,
                           const glm::dvec3&) { return std::abs(glm::length(point) - 1); },
            .at = [](const glm::dvec3& coordinate) { return glm::normalize(coordinate); }};
}

Analytic pnTriangle() {
    const std::array<glm::dvec3, 3> corners{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const PnTriangle exact(corners, corners);
    std::vector<glm::vec3> points;
    for (int i = 0; i < 2; ++i)
        for (const glm::dvec3& each : corners) points.emplace_back(each);
    return {.name = "pn-triangle",
            .title = "A PN triangle on an octant of a sphere",
            .unit = "radii",
            .reference =
                "the nearest point of the cubic triangle in double, by de Casteljau's algorithm and "
                "Gauss-Newton steps",
            .evaluation = Evaluation::pnTriangle,
            .points = std::move(points),
            .distance = [exact](const glm::dvec3& point,
                                const glm::dvec3& coordinate) { return exact.distance(point, coordinate); },
            .at = [exact](const glm::dvec3& coordinate) { return exact.at(coordinate); }};
}

std::vector<double> levelsOf(const Bench& bench, Spacing spacing) {
    if (bench.isQuick()) return {1, 2, 4, 8, 16, 32, 64};
    std::vector<double> levels{1, 2, 3, 4, 6, 8, 11, 16, 24, 32, 45, 64};
    if (spacing != Spacing::equal)
        for (const double between : {2.5, 9.5, 38.9}) levels.push_back(between);
    std::ranges::sort(levels);
    return levels;
}

struct Distances {
    double largest = 0, mean = 0;
    double atVertices = 0;  ///< largest distance of a vertex from the point of its own coordinate
};

Distances measureDistances(const Analytic& surface, const std::vector<TessellatedVertex>& vertices) {
    Distances found;
    double count = 0;
    for (std::size_t first = 0; first + 2 < vertices.size(); first += 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            const TessellatedVertex& vertex = vertices[first + i];
            const glm::dvec3 exact = surface.at(glm::dvec3(vertex.coordinate));
            found.atVertices = std::max(found.atVertices, glm::length(glm::dvec3(vertex.position) - exact));
        }
        for (int i = 0; i <= kCells; ++i)
            for (int j = 0; i + j <= kCells; ++j) {
                const glm::dvec3 weights = glm::dvec3(i, j, kCells - i - j) / static_cast<double>(kCells);
                glm::dvec3 position(0), coordinate(0);
                for (int corner = 0; corner < 3; ++corner) {
                    const TessellatedVertex& vertex = vertices[first + static_cast<std::size_t>(corner)];
                    position += weights[corner] * glm::dvec3(vertex.position);
                    coordinate += weights[corner] * glm::dvec3(vertex.coordinate);
                }
                const double distance = surface.distance(position, coordinate);
                found.largest = std::max(found.largest, distance);
                found.mean += distance;
                ++count;
            }
    }
    found.mean /= std::max(count, 1.);
    return found;
}

Figure distanceFigure(const Analytic& surface, std::string_view measure) {
    return {.name = fmt::format("{}-{}", surface.name, measure),
            .title = fmt::format("{}: {} distance of the triangles from the surface", surface.title, measure),
            .settingName = "tessellation level",
            .errorName = fmt::format("{} distance", measure),
            .errorUnit = std::string(surface.unit),
            .reference = std::string(surface.reference)};
}

/// The distance of the PN surface itself from the sphere that it approximates.
std::string modelFinding(const Analytic& surface) {
    constexpr int kSteps = 64;
    double largest = 0;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; i + j <= kSteps; ++j) {
            const glm::dvec3 where = glm::dvec3(i, j, kSteps - i - j) / static_cast<double>(kSteps);
            largest = std::max(largest, std::abs(glm::length(surface.at(where)) - 1));
        }
    return fmt::format("the PN triangle itself is up to {} radii away from the sphere, whatever the level",
                       numberText(largest));
}

Result<std::vector<Figure>> measureSurface(const Bench& bench, const gpu::Capabilities& capabilities,
                                           const Analytic& surface) {
    Figure largest = distanceFigure(surface, "largest"), mean = distanceFigure(surface, "mean");
    Result<gpu::Target> target =
        gpu::Target::window(capabilities, kPicture, kPicture, gpu::TexelFormat::rgba8);
    if (!target) return std::move(target.diagnostics);
    double atVertices = 0;
    for (const Spacing spacing : kSpacings) {
        Result<Tessellator> tessellator =
            Tessellator::create(capabilities, surface.evaluation, spacing, surface.points);
        if (!tessellator) return std::move(tessellator.diagnostics);
        Curve worst{.name = std::string(name(spacing))}, average{.name = std::string(name(spacing))};
        for (const double level : levelsOf(bench, spacing)) {
            const Levels levels{.outer = static_cast<float>(level), .inner = static_cast<float>(level)};
            Result<std::vector<TessellatedVertex>> vertices = tessellator->capture(levels);
            if (!vertices) return std::move(vertices.diagnostics);
            const Distances found = measureDistances(surface, *vertices);
            atVertices = std::max(atVertices, found.atVertices);
            target->bind();
            target->clearColor(0, {});
            Point point{.setting = level,
                        .label = fmt::format("level {:g}, {} triangles", level, vertices->size() / 3),
                        .error = found.largest,
                        .memory = static_cast<double>(vertices->size() * sizeof(glm::vec3))};
            point.time = bench.time([&] { tessellator->draw(levels); });
            worst.points.push_back(point);
            point.error = found.mean;
            average.points.push_back(std::move(point));
        }
        largest.findings.push_back(orderSentence(worst, "level", kFitFrom));
        mean.findings.push_back(orderSentence(average, "level", kFitFrom));
        largest.curves.push_back(std::move(worst));
        mean.curves.push_back(std::move(average));
    }
    largest.findings.push_back(
        fmt::format("vertices lie within {} {} of the points that their coordinates stand for, in double",
                    numberText(atVertices), surface.unit));
    if (surface.evaluation == Evaluation::pnTriangle) largest.findings.push_back(modelFinding(surface));
    return std::vector{std::move(largest), std::move(mean)};
}

}  // namespace

Result<std::vector<Figure>> measureTessellation(Bench& bench) {
    Result<gpu::Context*> context = bench.context();
    if (!context) return std::move(context.diagnostics);
    const gpu::Capabilities& capabilities = (*context)->capabilities();
    std::vector<Figure> figures;
    for (const Analytic& surface : {bezierPatch(), sphereOctant(), pnTriangle()}) {
        Result<std::vector<Figure>> more = measureSurface(bench, capabilities, surface);
        if (!more) return std::move(more.diagnostics);
        std::ranges::move(*more, std::back_inserter(figures));
    }
    Result<std::vector<Figure>> cracks = measureCracks(bench, capabilities);
    if (!cracks) return std::move(cracks.diagnostics);
    std::ranges::move(*cracks, std::back_inserter(figures));
    return figures;
}

}  // namespace glibra::bench
