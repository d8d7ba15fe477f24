#include "bench/subjects/tessellation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>

#include "bench/subjects/teapot.h"

namespace glibra::bench {
namespace {

constexpr int kFloatsAVertex = 7;
constexpr int kCells = 4;  // distances are taken at 15 points of each triangle
constexpr double kFitFrom = 8;

// Patches are numbered over several draws.
constexpr std::string_view kPatchVertex = R"(uniform float uFirst;
out float vPatch;
void main() { vPatch = uFirst + float(gl_VertexID); gl_Position = vec4(0.); }
)";
constexpr std::string_view kControl = R"(layout(vertices = 1) out;
in float vPatch[];
out float cPatch[];
uniform vec3 uLevels;
void main() {
    cPatch[gl_InvocationID] = vPatch[0];
    float inner = uLevels.y + uLevels.z * mod(vPatch[0], 3.);
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uLevels.x;
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inner;
}
)";
// Start and end of all evaluation shaders; {0} is the layout, {1} the functions, among them `surface`.
constexpr std::string_view kEvaluation = R"(#version 410 core
layout({0}, ccw) in;
layout(std140) uniform Points {{ vec4 uPoints[1024]; }};
in float cPatch[];
out vec3 vPosition;
out vec4 vWhere;
int patchNumber;
{1}void main() {{
    patchNumber = int(cPatch[0]);
    vPosition = surface();
    vWhere = vec4(gl_TessCoord, float(patchNumber));
    gl_Position = vec4(vPosition.xy * .4, vPosition.z * .1, 1.);
}}
)";
constexpr std::string_view kBernsteinGlsl = R"(vec4 weights(float t) {
    float s = 1. - t;
    return vec4(s * s * s, 3. * s * s * t, 3. * s * t * t, t * t * t);
}
vec3 surface() {
    vec4 u = weights(gl_TessCoord.x), v = weights(gl_TessCoord.y);
    vec3 sum = vec3(0.);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            sum += u[column] * v[row] * uPoints[patchNumber * 16 + row * 4 + column].xyz;
    return sum;
}
)";
/// A patch as four curves along v and one along u; `curve` must precede it.
constexpr std::string_view kCurveOfCurves = R"(vec3 surface() {
    vec3 along[4];
    for (int column = 0; column < 4; ++column) {
        int first = patchNumber * 16 + column;
        along[column] = curve(uPoints[first].xyz, uPoints[first + 4].xyz, uPoints[first + 8].xyz,
                              uPoints[first + 12].xyz, gl_TessCoord.y);
    }
    return curve(along[0], along[1], along[2], along[3], gl_TessCoord.x);
}
)";
constexpr std::string_view kInterpolatedGlsl = R"(vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {
    vec3 ab = mix(a, b, t), bc = mix(b, c, t), cd = mix(c, d, t);
    return mix(mix(ab, bc, t), mix(bc, cd, t), t);
}
)";
constexpr std::string_view kSymmetricGlsl = R"(vec3 curve(vec3 a, vec3 b, vec3 c, vec3 d, float t) {
    precise float s = 1. - t;
    precise vec3 ends = s * s * s * a + t * t * t * d;
    precise vec3 middle = s * s * t * b + t * t * s * c;
    precise vec3 sum = ends + 3. * middle;
    return sum;
}
)";
constexpr std::string_view kOctantGlsl = R"(vec3 surface() { return normalize(gl_TessCoord); }
)";
constexpr std::string_view kPnGlsl = R"(vec3 corner(int i) { return uPoints[patchNumber * 6 + i].xyz; }
vec3 normal(int i) { return uPoints[patchNumber * 6 + 3 + i].xyz; }
vec3 near(int i, int j) {
    return (2. * corner(i) + corner(j) - dot(corner(j) - corner(i), normal(i)) * normal(i)) / 3.;
}
vec3 surface() {
    float u = gl_TessCoord.x, v = gl_TessCoord.y, w = gl_TessCoord.z;
    vec3 edges = near(0, 1) + near(1, 0) + near(1, 2) + near(2, 1) + near(2, 0) + near(0, 2);
    vec3 middle = edges / 4. - (corner(0) + corner(1) + corner(2)) / 6.;
    return corner(0) * u * u * u + corner(1) * v * v * v + corner(2) * w * w * w
         + 3. * (near(0, 1) * u * u * v + near(1, 0) * u * v * v + near(1, 2) * v * v * w
               + near(2, 1) * v * w * w + near(2, 0) * w * w * u + near(0, 2) * w * u * u)
         + 6. * middle * u * v * w;
}
)";
constexpr std::string_view kPatchFragment = R"(in vec3 vPosition;
out vec4 fColor;
void main() { fColor = vec4(fract(vPosition.z)); }
)";

/// "equal spacing" and so on.
std::string spacingName(std::string_view spacing) {
    std::string name(spacing);
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string evaluationText(const Surface& surface, std::string_view spacing) {
    return fmt::format(kEvaluation, fmt::format("{}, {}", surface.layout, spacing),
                       fmt::format("{}{}", surface.glsl, surface.more));
}

double captureBytes(const std::vector<TessellatedVertex>& vertices) {
    return static_cast<double>(vertices.size() * sizeof(glm::vec3));
}

/// A surface, and the distance of a point from it.
struct Analytic {
    const char *name, *title, *unit, *reference;
    const Surface* drawn = nullptr;
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
        .drawn = &kBernstein,
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
            .drawn = &kSphereOctant,
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
            .drawn = &kPnTriangle,
            .points = std::move(points),
            .distance = [exact](const glm::dvec3& point,
                                const glm::dvec3& coordinate) { return exact.distance(point, coordinate); },
            .at = [exact](const glm::dvec3& coordinate) { return exact.at(coordinate); }};
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

/// The distance of the PN surface itself from the sphere that it approximates.
void noteModel(Figure& figure, const Analytic& surface) {
    constexpr int kSteps = 64;
    double largest = 0;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; i + j <= kSteps; ++j) {
            const glm::dvec3 where = glm::dvec3(i, j, kSteps - i - j) / static_cast<double>(kSteps);
            largest = std::max(largest, std::abs(glm::length(surface.at(where)) - 1));
        }
    figure.note("the PN triangle itself is up to {} radii away from the sphere, whatever the level",
                numberText(largest));
}

std::vector<Figure> surfaceFigures(Bench& bench, const Analytic& surface) {
    const auto figureOf = [&](const char* measure) {
        return Figure{
            .name = fmt::format("{}-{}", surface.name, measure),
            .title = fmt::format("{}: {} distance of the triangles from the surface", surface.title, measure),
            .settingName = "tessellation level",
            .errorName = fmt::format("{} distance", measure),
            .errorUnit = surface.unit,
            .reference = surface.reference};
    };
    Figure largest = figureOf("largest"), mean = figureOf("mean");
    double atVertices = 0;
    for (const std::string_view spacing : kSpacings) {
        const Tessellator tessellator(bench, *surface.drawn, spacing, surface.points);
        std::vector<double> levels = bench.pick(std::vector<double>{1, 2, 4, 8, 16, 32, 64},
                                                {1, 2, 3, 4, 6, 8, 11, 16, 24, 32, 45, 64});
        if (!bench.isQuick() && spacing != kSpacings[0]) levels.insert(levels.end(), {2.5, 9.5, 38.9});
        std::ranges::sort(levels);
        for (const double level : levels) {
            const Levels both{.outer = static_cast<float>(level), .inner = static_cast<float>(level)};
            const std::vector<TessellatedVertex> vertices = tessellator.capture(both);
            const Distances found = measureDistances(surface, vertices);
            atVertices = std::max(atVertices, found.atVertices);
            Point point{level, fmt::format("level {:g}, {} triangles", level, vertices.size() / 3),
                        found.largest, tessellator.timeDrawing(both), captureBytes(vertices)};
            largest.add(spacingName(spacing), point);
            point.error = found.mean;
            mean.add(spacingName(spacing), std::move(point));
        }
    }
    largest.noteOrders("level", kFitFrom);
    mean.noteOrders("level", kFitFrom);
    largest.note("vertices lie within {} {} of the points that their coordinates stand for, in double",
                 numberText(atVertices), surface.unit);
    if (surface.drawn == &kPnTriangle) noteModel(largest, surface);
    return {std::move(largest), std::move(mean)};
}

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

Figure crackFigure(Bench& bench) {
    const ControlPoints points = turnedTeapot();
    const std::vector<SharedEdge> shared = sharedEdges(points);
    Figure figure{
        .name = "cracks",
        .title =
            "Vertices that differ on shared edges: the teapot's patches, each turned, with different "
            "inner levels",
        .settingName = "outer tessellation level",
        .errorName = "share of vertices that differ from the neighbour's in any bit",
        .reference =
            fmt::format("the neighbour's own vertex at the same place of the edge; {} edges have the same "
                        "control points bit for bit, {} of them run the other way",
                        shared.size(), std::ranges::count_if(shared, &SharedEdge::isReversed)),
        .alternatives = Alternatives::setting};
    const std::vector<float> levels =
        bench.pick(std::vector<float>{1, 3, 8, 32}, {1, 2, 3, 4, 5.5, 7, 8, 11.3F, 16, 24, 32, 45.9F, 62});
    for (const Surface* surface : {&kBernstein, &kInterpolated, &kSymmetric})
        for (const std::string_view spacing : kSpacings) {
            const Tessellator teapot(bench, *surface, spacing, points);
            const std::string curve = fmt::format("{}, {}", surface->name, spacingName(spacing));
            Cracks all;
            for (const float level : levels) {
                const Levels stepped{.outer = level, .inner = level, .innerStep = 1};
                const std::vector<TessellatedVertex> vertices = teapot.capture(stepped);
                const Cracks found = countCracks(shared, edgeVertices(vertices, teapot.patches()));
                const double share =
                    static_cast<double>(found.different + found.withoutPartner) / found.vertices;
                figure.add(curve, {static_cast<double>(level), fmt::format("level {:g}", level), share,
                                   teapot.timeDrawing(stepped), captureBytes(vertices)});
                all.vertices += found.vertices;
                all.different += found.different;
                all.withoutPartner += found.withoutPartner;
                all.widest = std::max(all.widest, found.widest);
            }
            figure.note("{}: {} of {} vertices differ, by up to {} teapot units; {} have no partner", curve,
                        all.different, all.vertices, numberText(all.widest), all.withoutPartner);
        }

    // How many patches come out whole if one draw draws all.
    constexpr float kLevel = 62;
    const Tessellator teapot(bench, kSymmetric, kSpacings[0], points);
    const std::vector<TessellatedVertex> vertices =
        teapot.capture({.outer = kLevel, .inner = kLevel}, teapot.patches());
    std::vector<std::size_t> count(static_cast<std::size_t>(teapot.patches()), 0);
    for (const TessellatedVertex& each : vertices) ++count[static_cast<std::size_t>(each.patch)];
    figure.note("{} of {} patches of level {} come out right when they are one draw",
                std::ranges::count(count, vertices.size() / count.size()), count.size(), kLevel);
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
Figure levelGapFigure(Bench& bench) {
    Figure figure{.name = "level-gaps",
                  .title = "Gaps along an edge of the teapot's spout whose two sides have levels n and n + 1",
                  .settingName = "lower tessellation level",
                  .errorName = "largest gap",
                  .errorUnit = "teapot units",
                  .reference = "the other side's polyline, in double; equal levels leave no gap",
                  .alternatives = Alternatives::setting};
    const ControlPoints all = turnedTeapot();
    constexpr std::size_t kFirst = 16 * std::size_t{geometry::kTeapotSpout};
    for (const std::string_view spacing : kSpacings) {
        const Tessellator patch(bench, kSymmetric, spacing, std::span(all).subspan(kFirst, 16));
        for (const float level :
             bench.pick(std::vector<float>{1, 2, 4, 8, 16, 32}, {1, 2, 3, 4, 6, 8, 11, 16, 22, 32, 45, 62})) {
            std::array<EdgeVertices, 2> sides;
            double bytes = 0;
            for (std::size_t i = 0; i < 2; ++i) {
                const float own = level + static_cast<float>(i);
                const std::vector<TessellatedVertex> vertices = patch.capture({.outer = own, .inner = own});
                bytes += captureBytes(vertices);
                sides[i] = edgeVertices(vertices, 1)[static_cast<std::size_t>(Side::left)];
            }
            figure.add(spacingName(spacing),
                       {static_cast<double>(level), fmt::format("{:g} against {:g}", level, level + 1),
                        std::max(widestGap(sides[0], sides[1]), widestGap(sides[1], sides[0])), std::nullopt,
                        bytes});
        }
    }
    figure.noteOrders("level", 4);
    return figure;
}

/// The index of b(i,j,k) with i + j + k = degree among all, i falling, then j falling.
std::size_t placeOf(int degree, int i, int j) {
    const auto row = static_cast<std::size_t>(degree - i);
    return row * (row + 1) / 2 + row - static_cast<std::size_t>(j);
}

}  // namespace

const Surface kBernstein{"sum of Bernstein polynomials", "quads", 16, kBernsteinGlsl};
const Surface kInterpolated{"de Casteljau", "quads", 16, kInterpolatedGlsl, kCurveOfCurves};
const Surface kSymmetric{"symmetric pairs, precise", "quads", 16, kSymmetricGlsl, kCurveOfCurves};
const Surface kSphereOctant{"octant", "triangles", 1, kOctantGlsl};
const Surface kPnTriangle{"PN triangle", "triangles", 6, kPnGlsl};

Tessellator::Tessellator(Bench& bench, const Surface& surface, std::string_view spacing,
                         std::span<const glm::vec3> points)
    : bench_(bench),
      shader_(bench,
              std::array{gpu::StageSource{GL_VERTEX_SHADER, kPatchVertex},
                         gpu::StageSource{GL_TESS_CONTROL_SHADER, kControl},
                         gpu::StageSource{GL_TESS_EVALUATION_SHADER, evaluationText(surface, spacing)},
                         gpu::StageSource{GL_FRAGMENT_SHADER, kPatchFragment}},
              {"vPosition", "vWhere"}),
      points_(need(gpu::Buffer::create(1024 * sizeof(glm::vec4)))),
      patches_(static_cast<int>(std::max<std::size_t>(1, points.size() / surface.points))) {
    std::vector<glm::vec4> padded(1024, glm::vec4(0));
    for (std::size_t i = 0; i < std::min(points.size(), padded.size()); ++i) padded[i] = {points[i], 1};
    points_.update(0, std::as_bytes(std::span(padded)));
}

template <class Visit>
void Tessellator::forEachDraw(const Levels& levels, int patchesPerDraw, const Visit& visit) const {
    shader_.set("uLevels", glm::vec3(levels.outer, levels.inner, levels.innerStep));
    points_.bindBase(GL_UNIFORM_BUFFER, 0);
    const GLuint block = glGetUniformBlockIndex(shader_.id(), "Points");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(shader_.id(), block, 0);
    glPatchParameteri(GL_PATCH_VERTICES, 1);
    for (int first = 0; first < patches_; first += patchesPerDraw) {
        shader_.set("uFirst", 1. * first);
        visit(std::min(patchesPerDraw, patches_ - first));
    }
}

std::vector<TessellatedVertex> Tessellator::capture(const Levels& levels, int patchesPerDraw) const {
    // An upper bound of what a patch gives: twice the squares of the largest level, and a margin.
    const auto side = static_cast<int>(std::max(levels.outer, levels.inner + 2 * levels.innerStep)) + 3;
    std::vector<TessellatedVertex> vertices;
    forEachDraw(levels, patchesPerDraw, [&](int count) {
        const Captured captured =
            shader_.capture(GL_PATCHES, count, GL_TRIANGLES, kFloatsAVertex, count * side * side * 6);
        for (std::size_t i = 0; i + kFloatsAVertex <= captured.values.size(); i += kFloatsAVertex) {
            const float* from = captured.values.data() + i;
            vertices.push_back({.position = {from[0], from[1], from[2]},
                                .coordinate = {from[3], from[4], from[5]},
                                .patch = static_cast<int>(from[6])});
        }
    });
    return vertices;
}

Timing Tessellator::timeDrawing(const Levels& levels) const {
    const Canvas canvas(bench_, 256, 256, gpu::TexelFormat::rgba8);
    canvas.clear();
    return bench_.timeDrawing(
        [&] { forEachDraw(levels, kPatchesPerDraw, [&](int count) { shader_.draw(GL_PATCHES, count); }); });
}

PnTriangle::PnTriangle(const std::array<glm::dvec3, 3>& corners, const std::array<glm::dvec3, 3>& normals) {
    const auto towards = [&](std::size_t from, std::size_t to) {
        const glm::dvec3 step = corners[to] - corners[from];
        return corners[from] + (step - glm::dot(step, normals[from]) * normals[from]) / 3.;
    };
    const auto set = [&](int i, int j, const glm::dvec3& point) { points_[placeOf(3, i, j)] = point; };
    set(3, 0, corners[0]);
    set(0, 3, corners[1]);
    set(0, 0, corners[2]);
    set(2, 1, towards(0, 1));
    set(1, 2, towards(1, 0));
    set(0, 2, towards(1, 2));
    set(0, 1, towards(2, 1));
    set(1, 0, towards(2, 0));
    set(2, 0, towards(0, 2));
    const glm::dvec3 edges =
        (towards(0, 1) + towards(1, 0) + towards(1, 2) + towards(2, 1) + towards(2, 0) + towards(0, 2)) / 6.;
    const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.;
    set(1, 1, edges + (edges - middle) / 2.);
}

PnTriangle::Near PnTriangle::deCasteljau(const glm::dvec3& barycentric) const {
    std::array<glm::dvec3, 10> points = points_;
    for (int degree = 2; degree > 0; --degree)
        // In rising order, each result overwrites a point that is no longer needed.
        for (int i = degree; i >= 0; --i)
            for (int j = degree - i; j >= 0; --j)
                points[placeOf(degree, i, j)] = barycentric.x * points[placeOf(degree + 1, i + 1, j)] +
                                                barycentric.y * points[placeOf(degree + 1, i, j + 1)] +
                                                barycentric.z * points[placeOf(degree + 1, i, j)];
    return {barycentric.x * points[0] + barycentric.y * points[1] + barycentric.z * points[2],
            {points[0], points[1], points[2]}};
}

glm::dvec3 PnTriangle::at(const glm::dvec3& barycentric) const {
    return deCasteljau(barycentric).position;
}

double PnTriangle::distance(const glm::dvec3& point, const glm::dvec3& start) const {
    constexpr int kSteps = 6;
    constexpr double kDegree = 3;
    glm::dvec3 where = start;
    for (int step = 0; step < kSteps; ++step) {
        const Near near = deCasteljau(where);
        const glm::dvec3 along = kDegree * (near.last[0] - near.last[2]),
                         across = kDegree * (near.last[1] - near.last[2]), miss = point - near.position;
        const double aa = glm::dot(along, along), bb = glm::dot(across, across), ab = glm::dot(along, across);
        const double a = glm::dot(along, miss), b = glm::dot(across, miss);
        const double determinant = aa * bb - ab * ab;
        where.x += (bb * a - ab * b) / determinant;
        where.y += (aa * b - ab * a) / determinant;
        where.z = 1 - where.x - where.y;
    }
    return glm::length(point - at(where));
}

std::vector<Figure> measureTessellation(Bench& bench) {
    std::vector<Figure> figures;
    for (const Analytic& surface : {bezierPatch(), sphereOctant(), pnTriangle()})
        std::ranges::move(surfaceFigures(bench, surface), std::back_inserter(figures));
    figures.push_back(crackFigure(bench));
    figures.push_back(levelGapFigure(bench));
    return figures;
}

}  // namespace glibra::bench
