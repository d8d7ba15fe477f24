#include "bench/subjects/tessellation_cracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <span>
#include <string>

#include "bench/core/fit.h"
#include "bench/draw/tessellator.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

using ControlPoints = std::vector<glm::vec3>;

/// The edges of a quad patch, by the coordinate that is constant there.
enum class Side { left, right, bottom, top };
constexpr std::array kSides{Side::left, Side::right, Side::bottom, Side::top};

struct Edge {
    int patch = 0;
    Side side = Side::left;
};

/// Two edges whose control points are bit for bit the same.
struct SharedEdge {
    Edge first, second;
    bool isReversed = false;  ///< the second runs in the opposite direction
};

/// A vertex on an edge by its place along it, 0..1.
using EdgeVertices = std::map<float, glm::vec3>;

/// Rotates the control points by a quarter turn; the surface stays the same.
geometry::Patch turned(const geometry::Patch& patch) {
    geometry::Patch result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) result[row][column] = patch[3 - column][row];
    return result;
}

/// The patches of the teapot, rotated by different numbers of quarter turns: in the original, neighbours run
/// in the same direction.
ControlPoints turnedTeapot() {
    ControlPoints points;
    int number = 0;
    for (geometry::Patch patch : geometry::teapotPatches()) {
        for (int quarter = number++ * 5 / 3 % 4; quarter > 0; --quarter) patch = turned(patch);
        for (const auto& row : patch)
            for (const glm::dvec3& point : row) points.emplace_back(point);
    }
    return points;
}

std::array<glm::vec3, 4> edgePoints(const ControlPoints& points, const Edge& edge) {
    const std::span<const glm::vec3> patch =
        std::span(points).subspan(16 * static_cast<std::size_t>(edge.patch), 16);
    const auto at = [&](std::size_t row, std::size_t column) { return patch[row * 4 + column]; };
    std::array<glm::vec3, 4> along;
    for (std::size_t place = 0; place < 4; ++place)
        along[place] = edge.side == Side::left     ? at(place, 0)
                       : edge.side == Side::right  ? at(place, 3)
                       : edge.side == Side::bottom ? at(0, place)
                                                   : at(3, place);
    return along;
}

std::vector<SharedEdge> sharedEdges(const ControlPoints& points) {
    std::vector<Edge> edges;
    for (int patch = 0; patch < static_cast<int>(points.size() / 16); ++patch)
        for (const Side side : kSides) edges.push_back({patch, side});
    std::vector<SharedEdge> shared;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const std::array<glm::vec3, 4> first = edgePoints(points, edges[i]);
            std::array<glm::vec3, 4> second = edgePoints(points, edges[j]);
            if (first.front() == first.back() || edges[i].patch == edges[j].patch) continue;
            if (first == second) shared.push_back({edges[i], edges[j], false});
            std::ranges::reverse(second);
            if (first == second) shared.push_back({edges[i], edges[j], true});
        }
    return shared;
}

/// The vertices on every edge: [patch * 4 + side].
std::vector<EdgeVertices> edgeVertices(const std::vector<TessellatedVertex>& vertices, int patches) {
    std::vector<EdgeVertices> edges(static_cast<std::size_t>(patches) * 4);
    for (const TessellatedVertex& vertex : vertices) {
        const float u = vertex.coordinate.x, v = vertex.coordinate.y;
        const auto first = static_cast<std::size_t>(vertex.patch) * 4;
        if (u == 0) edges[first][v] = vertex.position;
        if (u == 1) edges[first + 1][v] = vertex.position;
        if (v == 0) edges[first + 2][u] = vertex.position;
        if (v == 1) edges[first + 3][u] = vertex.position;
    }
    return edges;
}

const EdgeVertices& verticesAlong(const std::vector<EdgeVertices>& edges, const Edge& edge) {
    return edges[static_cast<std::size_t>(edge.patch) * 4 + static_cast<std::size_t>(edge.side)];
}

bool isSamePlace(const glm::vec3& a, const glm::vec3& b) {
    for (glm::length_t i = 0; i < 3; ++i)
        // -0 and 0 are the same place.
        if (a[i] != b[i]) return false;
    return true;
}

struct Cracks {
    int vertices = 0, different = 0, withoutPartner = 0;
    double widest = 0;  ///< between a vertex and its partner
};

Cracks countCracks(const std::vector<SharedEdge>& shared, const std::vector<EdgeVertices>& edges) {
    Cracks count;
    for (const SharedEdge& each : shared) {
        const EdgeVertices& other = verticesAlong(edges, each.second);
        for (const auto& [place, position] : verticesAlong(edges, each.first)) {
            ++count.vertices;
            const auto partner = other.find(each.isReversed ? 1 - place : place);
            if (partner == other.end()) {
                ++count.withoutPartner;
            } else if (!isSamePlace(position, partner->second)) {
                ++count.different;
                count.widest =
                    std::max(count.widest, glm::length(glm::dvec3(position) - glm::dvec3(partner->second)));
            }
        }
    }
    return count;
}

std::string_view evaluationName(Evaluation evaluation) {
    switch (evaluation) {
        case Evaluation::interpolated:
            return "de Casteljau";
        case Evaluation::symmetric:
            return "symmetric pairs, precise";
        default:
            break;
    }
    return "sum of Bernstein polynomials";
}

/// How many patches come out whole if one draw draws all.
Result<std::string> wholePatches(const gpu::Capabilities& capabilities) {
    constexpr float kLevel = 62;
    Result<Tessellator> teapot =
        Tessellator::create(capabilities, Evaluation::symmetric, Spacing::equal, turnedTeapot());
    if (!teapot) return std::move(teapot.diagnostics);
    Result<std::vector<TessellatedVertex>> vertices =
        teapot->capture({.outer = kLevel, .inner = kLevel}, teapot->patches());
    if (!vertices) return std::move(vertices.diagnostics);
    std::vector<std::size_t> count(static_cast<std::size_t>(teapot->patches()), 0);
    for (const TessellatedVertex& each : *vertices) ++count[static_cast<std::size_t>(each.patch)];
    const auto whole = std::ranges::count(count, vertices->size() / count.size());
    return fmt::format("{} of {} patches of level {} come out right when they are one draw", whole,
                       count.size(), kLevel);
}

/// The curve of one way to tessellate over all levels; `all` receives the sum of its cracks. Draws into
/// `target`.
Result<Curve> crackCurve(const Bench& bench, const Tessellator& teapot, const std::vector<SharedEdge>& shared,
                         int patches, const gpu::Target& target, Cracks& all) {
    const std::vector<float> levels =
        bench.isQuick() ? std::vector<float>{1, 3, 8, 32}
                        : std::vector<float>{1, 2, 3, 4, 5.5, 7, 8, 11.3F, 16, 24, 32, 45.9F, 62};
    Curve curve;
    for (const float level : levels) {
        const Levels stepped{.outer = level, .inner = level, .innerStep = 1};
        const Result<std::vector<TessellatedVertex>> vertices = teapot.capture(stepped);
        if (!vertices) return vertices.diagnostics;
        target.bind();
        target.clearColor(0, {});
        const Cracks found = countCracks(shared, edgeVertices(*vertices, patches));
        curve.points.push_back(
            {.setting = static_cast<double>(level),
             .label = fmt::format("level {:g}", level),
             .error = static_cast<double>(found.different + found.withoutPartner) / found.vertices,
             .time = bench.time([&] { teapot.draw(stepped); }),
             .memory = static_cast<double>(vertices->size() * sizeof(glm::vec3))});
        all.vertices += found.vertices;
        all.different += found.different;
        all.withoutPartner += found.withoutPartner;
        all.widest = std::max(all.widest, found.widest);
    }
    return curve;
}

Figure emptyCrackFigure(const std::vector<SharedEdge>& shared) {
    return {.name = "cracks",
            .title =
                "Vertices that differ on shared edges: the teapot's patches, each turned, with different "
                "inner levels",
            .settingName = "outer tessellation level",
            .errorName = "share of vertices that differ from the neighbour's in any bit",
            .errorUnit = "",
            .reference = fmt::format(
                "the neighbour's own vertex at the same place of the edge; {} edges have the same "
                "control points bit for bit, {} of them run the other way",
                shared.size(), std::ranges::count_if(shared, &SharedEdge::isReversed))};
}

Result<Figure> sharedEdgeCracks(const Bench& bench, const gpu::Capabilities& capabilities) {
    const ControlPoints points = turnedTeapot();
    const std::vector<SharedEdge> shared = sharedEdges(points);
    Figure figure = emptyCrackFigure(shared);
    constexpr int kTimedSide = 256;  // pixels per side, for the time
    const Result<gpu::Target> target =
        gpu::Target::window(capabilities, kTimedSide, kTimedSide, gpu::TexelFormat::rgba8);
    if (!target) return target.diagnostics;
    for (const Evaluation evaluation :
         {Evaluation::bernstein, Evaluation::interpolated, Evaluation::symmetric})
        for (const Spacing spacing : kSpacings) {
            const Result<Tessellator> teapot = Tessellator::create(capabilities, evaluation, spacing, points);
            if (!teapot) return teapot.diagnostics;
            Cracks all;
            Result<Curve> curve =
                crackCurve(bench, *teapot, shared, static_cast<int>(points.size() / 16), *target, all);
            if (!curve) return std::move(curve.diagnostics);
            curve->name = fmt::format("{}, {}", evaluationName(evaluation), name(spacing));
            figure.findings.push_back(fmt::format(
                "{}: {} of {} vertices differ, by up to {} teapot units; {} have no partner", curve->name,
                all.different, all.vertices, numberText(all.widest), all.withoutPartner));
            figure.curves.push_back(std::move(*curve));
        }
    Result<std::string> whole = wholePatches(capabilities);
    if (!whole) return std::move(whole.diagnostics);
    figure.findings.push_back(std::move(*whole));
    return figure;
}

double distanceFromSegment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double size = glm::dot(along, along);
    const double place = size > 0 ? std::clamp(glm::dot(point - from, along) / size, 0., 1.) : 0;
    return glm::length(point - from - place * along);
}

/// The largest distance of a vertex of one polyline from the other.
double widestGap(const EdgeVertices& vertices, const EdgeVertices& line) {
    double widest = 0;
    for (const auto& [place, position] : vertices) {
        double nearest = std::numeric_limits<double>::infinity();
        for (auto to = std::next(line.begin()); to != line.end(); ++to)
            nearest =
                std::min(nearest, distanceFromSegment(glm::dvec3(position), glm::dvec3(std::prev(to)->second),
                                                      glm::dvec3(to->second)));
        widest = std::max(widest, nearest);
    }
    return widest;
}

/// Neighbours that disagree about the level of their edge.
Result<Figure> levelGaps(const Bench& bench, const gpu::Capabilities& capabilities) {
    Figure figure{.name = "level-gaps",
                  .title = "Gaps along an edge of the teapot's spout whose two sides have levels n and n + 1",
                  .settingName = "lower tessellation level",
                  .errorName = "largest gap",
                  .errorUnit = "teapot units",
                  .reference = "the other side's polyline, in double; equal levels leave no gap"};
    const ControlPoints all = turnedTeapot();
    constexpr std::size_t kFirst = 16 * std::size_t{geometry::kTeapotSpout};
    const std::span<const glm::vec3> points = std::span(all).subspan(kFirst, 16);
    const std::vector<float> levels = bench.isQuick()
                                          ? std::vector<float>{1, 2, 4, 8, 16, 32}
                                          : std::vector<float>{1, 2, 3, 4, 6, 8, 11, 16, 22, 32, 45, 62};
    for (const Spacing spacing : kSpacings) {
        Result<Tessellator> patch = Tessellator::create(capabilities, Evaluation::symmetric, spacing, points);
        if (!patch) return std::move(patch.diagnostics);
        Curve curve{.name = std::string(name(spacing))};
        for (const float level : levels) {
            std::array<EdgeVertices, 2> sides;
            double bytes = 0;
            for (std::size_t i = 0; i < 2; ++i) {
                const float own = level + static_cast<float>(i);
                Result<std::vector<TessellatedVertex>> vertices =
                    patch->capture({.outer = own, .inner = own});
                if (!vertices) return std::move(vertices.diagnostics);
                bytes += static_cast<double>(vertices->size() * sizeof(glm::vec3));
                sides[i] = edgeVertices(*vertices, 1)[static_cast<std::size_t>(Side::left)];
            }
            curve.points.push_back(
                {.setting = static_cast<double>(level),
                 .label = fmt::format("{:g} against {:g}", level, level + 1),
                 .error = std::max(widestGap(sides[0], sides[1]), widestGap(sides[1], sides[0])),
                 .memory = bytes});
        }
        figure.findings.push_back(orderSentence(curve, "level", 4));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measureCracks(const Bench& bench, const gpu::Capabilities& capabilities) {
    return measureEach({sharedEdgeCracks, levelGaps}, bench, capabilities);
}

}  // namespace glibra::bench
