#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numbers>
#include <span>

#include "bench/core/device.h"
#include "bench/reference/surfaces.h"
#include "bench/subjects/subjects.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

constexpr double kTube = .4, kSolidHeight = 2;
constexpr double kApex = 1e-6;  ///< nearer to its axis, a cone has no normal
constexpr double kPi = std::numbers::pi;

Foot footOnTorus(const glm::dvec3& p, const glm::dvec3& /*face*/) {
    const double around = std::hypot(p.x, p.y);
    const glm::dvec3 ring(p.x / around, p.y / around, 0);
    const glm::dvec3 across = p - ring;
    const double length = glm::length(across);
    return {std::abs(length - kTube), across / length};
}

bool isCap(const glm::dvec3& face) {
    return std::abs(face.y) > .999;
}

Foot footOnCylinder(const glm::dvec3& p, const glm::dvec3& face) {
    if (isCap(face)) return {std::abs(p.y - (face.y > 0 ? kSolidHeight : 0)), {0, face.y > 0 ? 1 : -1, 0}};
    const double around = std::hypot(p.x, p.z);
    return {std::abs(around - 1), {p.x / around, 0, p.z / around}};
}

Foot footOnCone(const glm::dvec3& p, const glm::dvec3& face) {
    if (isCap(face)) return {std::abs(p.y), {0, -1, 0}};
    const double around = std::hypot(p.x, p.z), slant = std::hypot(1., kSolidHeight);
    const double cosine = around > 0 ? p.x / around : 1, sine = around > 0 ? p.z / around : 0;
    return {std::abs(around * kSolidHeight + p.y - kSolidHeight) / slant,
            glm::dvec3(kSolidHeight * cosine, 1, kSolidHeight * sine) / slant, around > kApex};
}

/// A solid in closed form, and its meshes.
struct Solid {
    const char* name;
    /// For solids with slices: the mesh with n >= 6 of them around. Stacks and sides are n / 2; cylinder and
    /// cone have 1. For the others: with n cells along an edge.
    geometry::Mesh (*mesh)(int n);
    FootOn foot;  ///< null: distance and normals are not measured
    double volume;
    /// The largest dot(p, direction) over the solid (support function), for a unit direction.
    std::function<double(const glm::dvec3& direction)> extent;
    double unit = kSolidRadius;  ///< size of the mesh, in the units of extent and volume
};

std::vector<Solid> slicedSolids() {
    return {
        {"sphere", [](int n) { return geometry::sphere(kSolidRadius, n, n / 2); }, footOnSphere, 4 * kPi / 3,
         [](const glm::dvec3&) { return 1.; }},
        {"torus", [](int n) { return geometry::torus(kSolidRadius, kTube * kSolidRadius, n / 2, n); },
         footOnTorus, 2 * kPi * kPi * kTube * kTube,
         [](const glm::dvec3& d) { return std::hypot(d.x, d.y) + kTube; }},
        {"cylinder",
         [](int n) { return geometry::cylinder(kSolidRadius, kSolidHeight * kSolidRadius, n, 1); },
         footOnCylinder, kPi * kSolidHeight,
         [](const glm::dvec3& d) { return std::hypot(d.x, d.z) + std::max(0., kSolidHeight * d.y); }},
        {"cone", [](int n) { return geometry::cone(kSolidRadius, kSolidHeight * kSolidRadius, n, 1); },
         footOnCone, kPi * kSolidHeight / 3,
         [](const glm::dvec3& d) { return std::max(std::hypot(d.x, d.z), kSolidHeight * d.y); }},
    };
}

/// Solids whose faces or patches are cut into cells.
std::vector<Solid> cutSolids() {
    const TeapotPatches patches = placedTeapotPatches();
    return {{"soccer ball", [](int cells) { return geometry::soccerball(kSolidRadius, cells); }, footOnSphere,
             4 * kPi / 3, [](const glm::dvec3&) { return 1.; }},
            {"teapot", [](int cells) { return geometry::teapot(cells); }, nullptr, patchVolume(patches),
             PatchExtent(patches), 1}};
}

constexpr int kPictureSide = 1024;
/// Pixels; not an integer, so that no pixel centre lies on the edge.
constexpr double kPictureRadius = 500.3;
constexpr const char* kClosedForm =
    "the surface in closed form, in double; the distance along its normal from a net of 28 points on every "
    "triangle";

std::vector<int> sliceCounts(const Bench& bench) {
    return bench.pick(std::vector{8, 16, 32, 64}, {8, 16, 32, 64, 128, 256, 512});
}

std::string slicesLabel(int slices) {
    return fmt::format("{} slices", slices);
}

/// All measures of one mesh.
struct MeasuredMesh {
    int count = 0;  ///< slices or cells
    double triangles = 0, bytes = 0;
    double outline = 0, volume = 0, distance = 0, normal = 0, faceNormal = 0;  ///< errors
    Timing time;
};

struct Sweep {
    std::string name;
    std::vector<MeasuredMesh> meshes{};
};

Sweep measuredSweep(const Bench& bench, const Solid& solid, const std::vector<int>& counts) {
    Sweep sweep{solid.name};
    // The measures assume a mesh of size kSolidRadius.
    const double scale = kSolidRadius / solid.unit;
    const auto extent = [&](const glm::dvec3& direction) { return solid.extent(direction) / scale; };
    for (const int count : counts) {
        const geometry::Mesh mesh = solid.mesh(count);
        const MeshError error = solid.foot ? meshError(mesh, solid.foot) : MeshError{};
        sweep.meshes.push_back(
            {.count = count,
             .triangles = static_cast<double>(mesh.indices.size()) / 3,
             .bytes = meshBytes(mesh),
             .outline = kOutlineRadius * outlineError(mesh, extent) * scale,
             .volume = std::abs(std::abs(signedVolume(mesh)) * std::pow(scale, 3) / solid.volume - 1),
             .distance = error.distance,
             .normal = error.normal,
             .faceNormal = error.faceNormal,
             .time = bench.time([&] { solid.mesh(count); })});
    }
    return sweep;
}

using ErrorOf = double MeasuredMesh::*;

void addSweep(Figure& figure, const std::string& curve, const Sweep& sweep, ErrorOf error) {
    for (const MeasuredMesh& each : sweep.meshes)
        figure.add(curve, {1. * each.count, fmt::format("{} {}", each.count, figure.settingName), each.*error,
                           each.time, each.bytes});
}

/// One measure of several solids.
Figure byCounts(std::span<const Sweep> sweeps, ErrorOf error, Figure figure) {
    figure.alternatives = Alternatives::curve;
    for (const Sweep& each : sweeps) addSweep(figure, each.name, each, error);
    return figure;
}

Figure positionFigure(std::span<const Sweep> sweeps) {
    Figure figure = byCounts(sweeps, &MeasuredMesh::distance,
                             {.name = "position",
                              .title = "Distance of the mesh from the surface",
                              .settingName = "slices",
                              .errorName = "largest distance",
                              .errorUnit = "radii",
                              .reference = kClosedForm});
    figure.noteOrders("slices", 8);
    return figure;
}

Figure normalFigure(std::span<const Sweep> sweeps) {
    Figure figure = byCounts(sweeps, &MeasuredMesh::normal,
                             {.name = "normal",
                              .title = "Interpolated normals, and the normals of flat triangles",
                              .settingName = "slices",
                              .errorName = "largest angle",
                              .errorUnit = "degrees",
                              .reference = kClosedForm});
    addSweep(figure, "sphere, flat triangles", sweeps.front(), &MeasuredMesh::faceNormal);
    for (const Curve& each : figure.curves) figure.findings.push_back(angleSentence(each, "slices", 8));
    figure.note(
        "sphere, {}: interpolated normals are within {} degrees of the radius, flat triangles {} degrees "
        "off",
        figure.last(0).label, numberText(figure.last(0).error),
        numberText(figure.curves.back().points.back().error));
    return figure;
}

Figure outlineFigure(std::span<const Sweep> sweeps) {
    Figure figure = byCounts(
        sweeps, &MeasuredMesh::outline,
        {.name = "outline",
         .title = fmt::format("Outline, where the radius is {} pixels", kOutlineRadius),
         .settingName = "slices",
         .errorName = "largest distance of the outlines",
         .errorUnit = "pixels",
         .reference =
             "the solid's extent in closed form (its support function) in 360 directions of three views"});
    figure.noteOrders("slices", 8);
    for (const Curve& curve : figure.curves) {
        const double order = fittedOrder(curve, 8);
        const Point& last = curve.points.back();
        if (!(order < 0) || !(last.error > 0)) continue;
        figure.note("{}: half a pixel takes about {:.0f} slices", curve.name,
                    std::ceil(last.setting * std::pow(.5 / last.error, 1 / order)));
    }
    return figure;
}

Figure volumeFigure(std::span<const Sweep> sweeps) {
    Figure figure =
        byCounts(sweeps, &MeasuredMesh::volume,
                 {.name = "volume",
                  .title = "Volume",
                  .settingName = "slices",
                  .errorName = "relative error",
                  .reference = "the volume in closed form; the mesh's by the divergence theorem, in double"});
    figure.noteOrders("slices", 8);
    return figure;
}

/// Soccer ball and teapot by the number of cells along an edge of their faces or patches.
std::vector<Figure> cutFigures(const Bench& bench) {
    std::vector<Sweep> sweeps;
    for (const Solid& solid : cutSolids())
        sweeps.push_back(
            measuredSweep(bench, solid, bench.pick(std::vector{2, 4, 8}, {2, 3, 4, 6, 8, 12, 16, 24, 32})));
    const std::span<const Sweep> both = sweeps, ball = both.first(1);
    const char* const cells = "cells along an edge";
    std::vector<Figure> figures{
        byCounts(ball, &MeasuredMesh::distance,
                 {.name = "ball-position",
                  .title = "Soccer ball: distance of the mesh from the surface",
                  .settingName = cells,
                  .errorName = "largest distance",
                  .errorUnit = "radii",
                  .reference = "the sphere in closed form, at a net of 28 points on every triangle"}),
        byCounts(ball, &MeasuredMesh::normal,
                 {.name = "ball-normal",
                  .title = "Soccer ball: interpolated normals",
                  .settingName = cells,
                  .errorName = "largest angle",
                  .errorUnit = "degrees",
                  .reference = "the radius at the same places"}),
        byCounts(both, &MeasuredMesh::outline,
                 {.name = "cut-outline",
                  .title = fmt::format("Soccer ball and teapot: outline, a radius being {} pixels",
                                       kOutlineRadius),
                  .settingName = cells,
                  .errorName = "largest distance of the outlines",
                  .errorUnit = "pixels",
                  .reference =
                      "the extent in 360 directions of three views: of the sphere, and of the patches by a "
                      "search in double"}),
        byCounts(both, &MeasuredMesh::volume,
                 {.name = "cut-volume",
                  .title = "Soccer ball and teapot: volume",
                  .settingName = cells,
                  .errorName = "relative error",
                  .reference = "the sphere's, and the patches' by Gauss's quadrature, which is exact for "
                               "them; the meshes' by the divergence theorem"})};
    for (Figure& figure : figures)
        for (const Curve& curve : figure.curves)
            figure.findings.push_back(figure.errorUnit == "degrees" ? angleSentence(curve, "cells", 3)
                                                                    : orderSentence(curve, "cells", 3));
    return figures;
}

/// Slices with a fixed number of stacks: where more slices stop helping, stacks are missing.
Figure balanceFigure(const Bench& bench, const Sweep& balanced) {
    Figure figure{.name = "balance",
                  .title = "Sphere: slices with too few stacks",
                  .settingName = "slices",
                  .errorName = "largest distance",
                  .errorUnit = "radii",
                  .reference = kClosedForm};
    addSweep(figure, "stacks = slices / 2", balanced, &MeasuredMesh::distance);
    for (const int stacks : bench.pick(std::vector{8}, {8, 32, 128})) {
        const std::string name = fmt::format("{} stacks", stacks);
        for (const int slices : sliceCounts(bench)) {
            const geometry::Mesh mesh = geometry::sphere(kSolidRadius, slices, stacks);
            figure.add(
                name, {1. * slices, slicesLabel(slices), sphereError(mesh).distance,
                       bench.time([&] { geometry::sphere(kSolidRadius, slices, stacks); }), meshBytes(mesh)});
        }
        const Point& last = figure.curves.back().points.back();
        figure.note("{}: {} radii is all that {} reach", name, numberText(last.error), last.label);
    }
    return figure;
}

/// All shapes by the measure of cost that they share.
Figure triangleFigure(const Bench& bench, std::span<const Sweep> sweeps, const Figure& teapot) {
    constexpr double kTeapotTriangles = 16256;
    Figure figure{.name = "triangles",
                  .title = "Distance by the number of triangles",
                  .settingName = "triangles",
                  .errorName = "largest distance",
                  .errorUnit = "radii",
                  .reference = "closed forms, and the teapot's patches in double",
                  .alternatives = Alternatives::curve};
    const auto add = [&](const std::string& curve, double triangles, double error, const Timing& time,
                         double bytes) {
        figure.add(curve, {triangles, fmt::format("{:.0f} triangles", triangles), error, time, bytes});
    };
    for (const Sweep& sweep : sweeps)
        for (const MeasuredMesh& each : sweep.meshes)
            add(sweep.name, each.triangles, each.distance, each.time, each.bytes);
    const geometry::Mesh ball = geometry::soccerball(kSolidRadius);
    const double ballError = sphereError(ball).distance;
    add("soccer ball", static_cast<double>(ball.indices.size()) / 3, ballError,
        bench.time([] { geometry::soccerball(kSolidRadius); }), meshBytes(ball));
    const Point& shipped = teapot.curves.back().points.front();
    add("teapot", kTeapotTriangles, shipped.error, *shipped.time, *shipped.memory);
    const Curve& sphere = figure.curves.front();
    figure.findings.push_back(orderSentence(sphere, "triangles", 100));
    const Point& fine = sphere.points.back();
    const double equal = fine.setting * std::pow(ballError / fine.error, 1 / fittedOrder(sphere, 100));
    figure.note(
        "soccer ball: {} radii with {} triangles; a sphere of slices and stacks takes about {:.0f} for the "
        "same",
        numberText(ballError), ball.indices.size() / 3, equal);
    return figure;
}

Figure drawnFigure(Bench& bench) {
    Figure figure{
        .name = "drawn",
        .title = fmt::format("Sphere drawn in {0} x {0} pixels: area of the picture", kPictureSide),
        .settingName = "slices",
        .errorName = "mean distance of the outlines",
        .errorUnit = "pixels",
        .reference = fmt::format(
            "the disc's area, pi r^2 with r = {} pixels; covered pixels are counted, and the missing "
            "area is divided by the circumference. Time: upload and drawing",
            kPictureRadius)};
    const Shader shader(bench,
                        "layout(location = 0) in vec3 aPosition;\nuniform float uScale;\n"
                        "void main() { gl_Position = vec4(aPosition.xy * uScale, 0., 1.); }\n",
                        "out vec4 fColor;\nvoid main() { fColor = vec4(1); }\n");
    shader.set("uScale", 2 * kPictureRadius / kPictureSide);
    const Canvas canvas(bench, kPictureSide, kPictureSide, gpu::TexelFormat::rgba8);
    for (const int slices : sliceCounts(bench)) {
        const geometry::Mesh mesh = geometry::sphere(1, slices, slices / 2);
        canvas.clear();
        const Timing time = bench.timeDrawing([&] { Vertices(mesh, false).draw(shader); });
        const auto covered = static_cast<double>(std::ranges::count(canvas.pixels(1), 1.F));
        const double disc = kPi * kPictureRadius * kPictureRadius;
        figure.add("sphere", {1. * slices, slicesLabel(slices),
                              std::abs(covered - disc) / (2 * kPi * kPictureRadius), time, meshBytes(mesh)});
    }
    figure.findings.push_back(orderSentence(figure.curves[0], "slices", 8, 128));
    figure.note("sphere: {} pixels at {}, where counting whole pixels is the limit",
                numberText(figure.last(0).error), figure.last(0).label);
    return figure;
}

}  // namespace

std::vector<Figure> measurePrimitives(Bench& bench) {
    std::vector<Sweep> sweeps;
    for (const Solid& solid : slicedSolids())
        sweeps.push_back(measuredSweep(bench, solid, sliceCounts(bench)));
    std::vector<Figure> teapot = teapotFigures(bench);
    std::vector<Figure> figures{positionFigure(sweeps),
                                normalFigure(sweeps),
                                outlineFigure(sweeps),
                                volumeFigure(sweeps),
                                balanceFigure(bench, sweeps.front()),
                                triangleFigure(bench, sweeps, teapot.front())};
    std::ranges::move(teapot, std::back_inserter(figures));
    std::ranges::move(cutFigures(bench), std::back_inserter(figures));
    bench.attempt([&] { figures.push_back(drawnFigure(bench)); });
    return figures;
}

namespace {

constexpr int kShippedCells = 16;

/// A grid on every patch, rounded once to float, with (cells + 1)^2 vertices per patch.
geometry::Mesh patchGrid(const TeapotPatches& patches, int cells) {
    geometry::Mesh mesh;
    mesh.attributes = {{std::string(geometry::kPosition), 3, {}},
                       {std::string(geometry::kNormal), 3, {}},
                       {std::string(geometry::kTexCoord), 2, {}}};
    const auto stride = static_cast<std::uint32_t>(cells + 1);
    const auto append = [&](std::size_t attribute, const glm::dvec3& value) {
        geometry::Attribute& to = mesh.attributes[attribute];
        for (int i = 0; i < to.components; ++i) to.values.push_back(static_cast<float>(value[i]));
    };
    for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const glm::dvec2 st(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
                const PatchPoint at = patchPoint(patches[patch], st);
                const glm::dvec3 across = glm::cross(at.alongS, at.alongT);
                const double length = glm::length(across);
                append(0, at.position);
                append(1, length > 1e-12 ? across / length : glm::dvec3(0, j == 0 ? -1 : 1, 0));
                append(2, {st, 0});
            }
        for (std::uint32_t j = 0; j + 1 < stride; ++j)
            for (std::uint32_t i = 0; i + 1 < stride; ++i) {
                const std::uint32_t a = patch * stride * stride + j * stride + i;
                for (const std::uint32_t index : {a, a + 1, a + stride + 1, a, a + stride + 1, a + stride})
                    mesh.indices.push_back(index);
            }
    }
    return mesh;
}

std::string_view partOf(std::size_t patch) {
    using namespace geometry;
    if (patch >= kTeapotSpout) return "spout";
    if (patch >= kTeapotHandle) return "handle";
    if (patch >= kTeapotBottom) return "bottom";
    if (patch >= kTeapotLid) return "lid";
    return patch >= kTeapotBody ? "body" : "rim";
}

struct TeapotError {
    double distance = 0, normal = 0;
    std::string_view distanceAt, normalAt;  ///< the part with the largest errors
};

/// Every mesh here has its patches one after the other, with (cells + 1)^2 vertices each.
TeapotError errorOf(const geometry::Mesh& mesh, const TeapotPatches& patches, int cells) {
    const auto vertices = static_cast<std::uint32_t>((cells + 1) * (cells + 1));
    TeapotError largest;
    forEachTriangle(mesh, 3, [&](const Triangle& triangle, const glm::dvec3& weights) {
        const std::size_t number = triangle.vertices[0] / vertices;
        const geometry::Patch& patch = patches[number];
        const glm::dvec3 point = triangle.position(weights);
        const PatchPoint foot = patchPoint(patch, nearestOnPatch(patch, point, triangle.texCoord(weights)));
        if (const double distance = glm::distance(foot.position, point); distance > largest.distance) {
            largest.distance = distance;
            largest.distanceAt = partOf(number);
        }
        const glm::dvec3 across = glm::cross(foot.alongS, foot.alongT);
        // At the knob and at the centre of the bottom the derivatives vanish; close to them their direction
        // is only rounding.
        if (glm::length(across) < 1e-4) return;
        const double angle = angleBetween(triangle.normal(weights), glm::normalize(across));
        if (angle > largest.normal) {
            largest.normal = angle;
            largest.normalAt = partOf(number);
        }
    });
    return largest;
}

}  // namespace

std::vector<Figure> teapotFigures(const Bench& bench) {
    const TeapotPatches patches = placedTeapotPatches();
    Figure position{.name = "teapot-position",
                    .title = "Teapot: distance of the mesh from the patches",
                    .settingName = "cells per side of a patch",
                    .errorName = "largest distance",
                    .errorUnit = "radii",
                    .reference =
                        "the 32 bicubic patches by de Casteljau's algorithm in double, at the nearest "
                        "point that Gauss-Newton steps find"};
    Figure normal = position;
    normal.name = "teapot-normal";
    normal.title = "Teapot: interpolated normals";
    normal.errorName = "largest angle";
    normal.errorUnit = "degrees";
    const auto add = [&](const char* curve, int cells, const std::function<geometry::Mesh()>& make) {
        const geometry::Mesh mesh = make();
        const TeapotError found = errorOf(mesh, patches, cells);
        Point point{1. * cells, fmt::format("{0} x {0} cells", cells), found.distance,
                    bench.time([&] { make(); }), meshBytes(mesh)};
        position.add(curve, point);
        point.error = found.normal;
        normal.add(curve, std::move(point));
        return found;
    };
    for (const int cells : bench.pick(std::vector{4, 8}, {2, 4, 8, 16, 32}))
        add("grid on every patch", cells, [&] { return patchGrid(patches, cells); });
    const TeapotError found = add("the teapot of scenes", kShippedCells, [] { return geometry::teapot(); });
    for (Figure* each : {&position, &normal}) each->findings = {orderSentence(each->curves[0], "cells")};
    position.note("the teapot of scenes is {} radii from its patches, farthest at the {}",
                  numberText(found.distance), found.distanceAt);
    normal.note("the teapot of scenes: {} degrees, at the {}", numberText(found.normal), found.normalAt);
    return {std::move(position), std::move(normal)};
}

}  // namespace glibra::bench
