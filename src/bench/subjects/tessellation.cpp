#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>

#include "bench/core/device.h"
#include "bench/reference/surfaces.h"
#include "bench/subjects/subjects.h"
#include "embedded/bench_shaders.h"

namespace glibra::bench {
namespace {

constexpr int kFloatsAVertex = 7;
constexpr int kCells = 4;  // distances are taken at 15 points of each triangle
constexpr double kFitFrom = 8;

/// "equal_spacing", "fractional_even_spacing" and "fractional_odd_spacing", as GLSL's layouts name them.
constexpr std::array<std::string_view, 3> kSpacings{"equal_spacing", "fractional_even_spacing",
                                                    "fractional_odd_spacing"};

/// What shaders/patch.tese computes.
struct Surface {
    const char *name, *domain;
    std::size_t points;  ///< control points of a patch
    const char* macro;
};
/// Bicubic patches of 16 control points, rows along v: by a sum of Bernstein polynomials, by repeated
/// interpolation, and by a sum of symmetric pairs marked `precise`.
constexpr Surface kBernstein{"sum of Bernstein polynomials", "quads", 16, "BERNSTEIN"},
    kInterpolated{"de Casteljau", "quads", 16, "DE_CASTELJAU"},
    kSymmetric{"symmetric pairs, precise", "quads", 16, "SYMMETRIC"};
/// An octant of the unit sphere is a triangle whose points are normalised. PN triangles take three corners
/// and three normals.
constexpr Surface kSphereOctant{"octant", "triangles", 1, "OCTANT"},
    kPnTriangle{"PN triangle", "triangles", 6, "PN_TRIANGLE"};

/// "equal spacing" and so on.
std::string spacingName(std::string_view spacing) {
    std::string name(spacing);
    std::ranges::replace(name, '_', ' ');
    return name;
}

struct TessellatedVertex {
    glm::vec3 position{0};
    glm::vec3 coordinate{0};  ///< gl_TessCoord
    int patch = 0;
};

/// Levels of all patches. The outer levels are equal; the inner ones may grow from patch to patch, by 0, 1,
/// 2, 0, 1 ... steps.
struct Levels {
    float outer = 1, inner = 1, innerStep = 0;
};

class Tessellator {
  public:
    /// llvmpipe (Mesa 22.3) numbers the vertices of one draw with 16 bits and repeats the first patches
    /// beyond that; 8 patches of level 64 stay below.
    static constexpr int kPatchesPerDraw = 8;

    /// `points`: the control points of all patches, at most 1024.
    Tessellator(Bench& bench, const Surface& surface, std::string_view spacing,
                std::span<const glm::vec3> points)
        : bench_(bench),
          shader_(
              bench,
              std::array{gpu::StageSource{GL_VERTEX_SHADER, bench_shaders::patch_vert()},
                         gpu::StageSource{GL_TESS_CONTROL_SHADER, bench_shaders::patch_tesc()},
                         gpu::StageSource{GL_TESS_EVALUATION_SHADER,
                                          fmt::format("#define DOMAIN {}\n#define SPACING {}\n#define {}\n{}",
                                                      surface.domain, spacing, surface.macro,
                                                      bench_shaders::patch_tese())},
                         gpu::StageSource{GL_FRAGMENT_SHADER, bench_shaders::patch_frag()}},
              {"vPosition", "vWhere"}),
          points_(need(gpu::Buffer::create(1024 * sizeof(glm::vec4)))),
          patches_(static_cast<int>(std::max<std::size_t>(1, points.size() / surface.points))) {
        std::vector<glm::vec4> padded(1024, glm::vec4(0));
        for (std::size_t i = 0; i < std::min(points.size(), padded.size()); ++i) padded[i] = {points[i], 1};
        points_.update(0, std::as_bytes(std::span(padded)));
    }

    /// Three vertices per triangle.
    [[nodiscard]] std::vector<TessellatedVertex> capture(const Levels& levels,
                                                         int patchesPerDraw = kPatchesPerDraw) const {
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
    [[nodiscard]] int patches() const { return patches_; }
    /// Draws all patches into a cleared picture of 256 x 256 pixels, seen along -z, grey by height.
    [[nodiscard]] Timing timeDrawing(const Levels& levels) const {
        const Canvas canvas(bench_, 256, 256, gpu::TexelFormat::rgba8);
        canvas.clear();
        return bench_.timeDrawing([&] {
            forEachDraw(levels, kPatchesPerDraw, [&](int count) { shader_.draw(GL_PATCHES, count); });
        });
    }

  private:
    /// Calls visit(count) for the patches of each draw.
    template <class Visit>
    void forEachDraw(const Levels& levels, int patchesPerDraw, const Visit& visit) const {
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

    Bench& bench_;
    Shader shader_;
    gpu::Buffer points_;
    int patches_;
};

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

/// The edges of a quad patch, u = 0, u = 1, v = 0 and v = 1, by the first control point and the step to the
/// next one. The edges of several patches are numbered patch * 4 + side.
struct Side {
    std::size_t first, step;
};
constexpr std::array kSides{Side{0, 4}, Side{3, 4}, Side{0, 1}, Side{12, 1}};

/// Two edges whose control points are bit for bit the same.
struct SharedEdge {
    std::size_t first = 0, second = 0;
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

std::array<glm::vec3, 4> edgePoints(const ControlPoints& points, std::size_t edge) {
    const auto [first, step] = kSides.at(edge % 4);
    std::array<glm::vec3, 4> along;
    for (std::size_t i = 0; i < 4; ++i) along[i] = points[edge / 4 * 16 + first + i * step];
    return along;
}

std::vector<SharedEdge> sharedEdges(const ControlPoints& points) {
    const std::size_t edges = points.size() / 16 * 4;
    std::vector<SharedEdge> shared;
    for (std::size_t i = 0; i < edges; ++i)
        for (std::size_t j = i + 1; j < edges; ++j) {
            const std::array<glm::vec3, 4> first = edgePoints(points, i);
            std::array<glm::vec3, 4> second = edgePoints(points, j);
            if (first.front() == first.back() || i / 4 == j / 4) continue;
            if (first == second) shared.push_back({i, j, false});
            std::ranges::reverse(second);
            if (first == second) shared.push_back({i, j, true});
        }
    return shared;
}

/// The vertices on every edge.
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

struct Cracks {
    int vertices = 0, different = 0, withoutPartner = 0;
    double widest = 0;  ///< between a vertex and its partner
};

Cracks countCracks(const std::vector<SharedEdge>& shared, const std::vector<EdgeVertices>& edges) {
    Cracks count;
    for (const SharedEdge& each : shared) {
        const EdgeVertices& other = edges[each.second];
        for (const auto& [place, position] : edges[each.first]) {
            ++count.vertices;
            const auto partner = other.find(each.isReversed ? 1 - place : place);
            if (partner == other.end()) {
                ++count.withoutPartner;
            } else if (position != partner->second) {  // -0 and 0 are the same place
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
                sides[i] = edgeVertices(vertices, 1).front();
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

}  // namespace

std::vector<Figure> measureTessellation(Bench& bench) {
    std::vector<Figure> figures;
    for (const Analytic& surface : {bezierPatch(), sphereOctant(), pnTriangle()})
        std::ranges::move(surfaceFigures(bench, surface), std::back_inserter(figures));
    figures.push_back(crackFigure(bench));
    figures.push_back(levelGapFigure(bench));
    return figures;
}

}  // namespace glibra::bench
