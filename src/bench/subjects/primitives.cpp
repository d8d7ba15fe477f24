#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "bench/core/fit.h"
#include "bench/draw/drawn_solid.h"
#include "bench/reference/solids.h"
#include "bench/subjects/cut_shapes.h"
#include "bench/subjects/subjects.h"
#include "bench/subjects/teapot.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"

namespace glibra::bench {
namespace {

constexpr int kPictureSide = 1024;
constexpr double kPictureRadius =
    500.3;  ///< pixels; not an integer, so that no pixel centre lies on the edge
constexpr const char* kClosedForm =
    "the surface in closed form, in double; the distance along its normal from a net of 28 points on every "
    "triangle";

std::vector<int> sliceCounts(const Bench& bench) {
    if (bench.isQuick()) return {8, 16, 32, 64};
    return {8, 16, 32, 64, 128, 256, 512};
}

/// All measures of one mesh.
struct MeasuredMesh {
    int slices = 0;
    double triangles = 0, bytes = 0, outline = 0, volume = 0;
    MeshError error;
    Timing time;
};

MeasuredMesh measureMesh(const Bench& bench, const Solid& solid, int slices) {
    const geometry::Mesh mesh = solid.mesh(slices);
    MeasuredMesh all;
    all.slices = slices;
    all.triangles = static_cast<double>(mesh.indices.size()) / 3;
    all.bytes = meshBytes(mesh);
    all.outline = outlineError(mesh, solid.extent) * kOutlineRadius;
    all.volume = std::abs(signedVolume(mesh) / solid.volume - 1);
    all.error = meshError(mesh, solid.foot);
    all.time = bench.time([&] { solid.mesh(slices); });
    return all;
}

using Sweep = std::vector<MeasuredMesh>;

Curve sliceCurve(std::string name, const Sweep& sweep, double (*error)(const MeasuredMesh&)) {
    Curve curve{std::move(name), {}};
    for (const MeasuredMesh& each : sweep)
        curve.points.push_back({.setting = static_cast<double>(each.slices),
                                .label = fmt::format("{} slices", each.slices),
                                .error = error(each),
                                .time = each.time,
                                .memory = each.bytes});
    return curve;
}

Figure bySlices(std::span<const Sweep> sweeps, double (*error)(const MeasuredMesh&)) {
    Figure figure;
    figure.settingName = "slices";
    figure.alternatives = Alternatives::curve;
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        figure.curves.push_back(sliceCurve(std::string(solids()[i].name), sweeps[i], error));
    return figure;
}

void addOrders(Figure& figure) {
    for (const Curve& each : figure.curves)
        figure.findings.push_back(orderSentence(each, figure.settingName, 8));
}

Figure positionFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, [](const MeasuredMesh& each) { return each.error.distance; });
    figure.name = "position";
    figure.title = "Distance of the mesh from the surface";
    figure.errorName = "largest distance";
    figure.errorUnit = "radii";
    figure.reference = kClosedForm;
    addOrders(figure);
    return figure;
}

Figure normalFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, [](const MeasuredMesh& each) { return each.error.normal; });
    figure.name = "normal";
    figure.title = "Interpolated normals, and the normals of flat triangles";
    figure.errorName = "largest angle";
    figure.errorUnit = "degrees";
    figure.reference = kClosedForm;
    figure.curves.push_back(sliceCurve("sphere, flat triangles", sweeps.front(),
                                       [](const MeasuredMesh& each) { return each.error.faceNormal; }));
    for (const Curve& each : figure.curves)
        figure.findings.push_back(angleSentence(each, figure.settingName, 8));
    const Point& smooth = figure.curves.front().points.back();
    figure.findings.push_back(fmt::format(
        "sphere, {}: interpolated normals are within {} degrees of the radius, flat triangles {} degrees off",
        smooth.label, numberText(smooth.error), numberText(figure.curves.back().points.back().error)));
    return figure;
}

Figure outlineFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, [](const MeasuredMesh& each) { return each.outline; });
    figure.name = "outline";
    figure.title = fmt::format("Outline, where the radius is {} pixels", kOutlineRadius);
    figure.errorName = "largest distance of the outlines";
    figure.errorUnit = "pixels";
    figure.reference =
        "the solid's extent in closed form (its support function) in 360 directions of three views";
    addOrders(figure);
    for (const Curve& curve : figure.curves) {
        const double order = fittedOrder(curve, 8);
        const Point& last = curve.points.back();
        if (!(order < 0) || !(last.error > 0)) continue;
        const double needed = last.setting * std::pow(.5 / last.error, 1 / order);
        figure.findings.push_back(
            fmt::format("{}: half a pixel takes about {:.0f} slices", curve.name, std::ceil(needed)));
    }
    return figure;
}

Figure volumeFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, [](const MeasuredMesh& each) { return each.volume; });
    figure.name = "volume";
    figure.title = "Volume";
    figure.errorName = "relative error";
    figure.reference = "the volume in closed form; the mesh's by the divergence theorem, in double";
    addOrders(figure);
    return figure;
}

/// Slices with a fixed number of stacks: where more slices stop helping, stacks are missing.
Figure balanceFigure(const Bench& bench, const Sweep& balanced) {
    Figure figure;
    figure.name = "balance";
    figure.title = "Sphere: slices with too few stacks";
    figure.settingName = "slices";
    figure.errorName = "largest distance";
    figure.errorUnit = "radii";
    figure.reference = kClosedForm;
    figure.curves.push_back(sliceCurve("stacks = slices / 2", balanced,
                                       [](const MeasuredMesh& each) { return each.error.distance; }));
    const std::vector<int> stackCounts = bench.isQuick() ? std::vector{8} : std::vector{8, 32, 128};
    for (const int stacks : stackCounts) {
        Curve curve{fmt::format("{} stacks", stacks), {}};
        for (const int slices : sliceCounts(bench)) {
            const geometry::Mesh mesh = geometry::sphere(kSolidRadius, slices, stacks);
            curve.points.push_back(
                {.setting = static_cast<double>(slices),
                 .label = fmt::format("{} slices", slices),
                 .error = sphereError(mesh).distance,
                 .time = bench.time([&] { geometry::sphere(kSolidRadius, slices, stacks); }),
                 .memory = meshBytes(mesh)});
        }
        const Point& last = curve.points.back();
        figure.findings.push_back(
            fmt::format("{}: {} radii is all that {} reach", curve.name, numberText(last.error), last.label));
        figure.curves.push_back(std::move(curve));
    }
    return figure;
}

/// All shapes by the measure of cost that they share.
Figure triangleFigure(const Bench& bench, std::span<const Sweep> sweeps, const Figure& teapot) {
    Figure figure;
    figure.name = "triangles";
    figure.title = "Distance by the number of triangles";
    figure.alternatives = Alternatives::curve;
    figure.settingName = "triangles";
    figure.errorName = "largest distance";
    figure.errorUnit = "radii";
    figure.reference = "closed forms, and the teapot's patches in double";
    const auto add = [](Curve& curve, double triangles, const Point& like) {
        Point& point = curve.points.emplace_back(like);
        point.setting = triangles;
        point.label = fmt::format("{:.0f} triangles", triangles);
    };
    const Figure positions = positionFigure(sweeps);
    for (std::size_t i = 0; i < sweeps.size(); ++i) {
        Curve& curve = figure.curves.emplace_back(Curve{positions.curves[i].name, {}});
        for (std::size_t k = 0; k < sweeps[i].size(); ++k)
            add(curve, sweeps[i][k].triangles, positions.curves[i].points[k]);
    }
    const geometry::Mesh ball = geometry::soccerball(kSolidRadius);
    Point ballPoint;
    ballPoint.error = sphereError(ball).distance;
    ballPoint.time = bench.time([] { geometry::soccerball(kSolidRadius); });
    ballPoint.memory = meshBytes(ball);
    add(figure.curves.emplace_back(Curve{"soccer ball", {}}), static_cast<double>(ball.indices.size()) / 3,
        ballPoint);
    const Point& shipped = teapot.curves.back().points.front();
    add(figure.curves.emplace_back(Curve{"teapot", {}}), kTeapotTriangles, shipped);

    const Curve& sphere = figure.curves.front();
    figure.findings.push_back(orderSentence(sphere, "triangles", 100));
    const double order = fittedOrder(sphere, 100);
    const Point& fine = sphere.points.back();
    const double equal = fine.setting * std::pow(ballPoint.error / fine.error, 1 / order);
    figure.findings.push_back(
        fmt::format("soccer ball: {} radii with {} triangles; a sphere of slices and "
                    "stacks takes about {:.0f} for the same",
                    numberText(ballPoint.error), ball.indices.size() / 3, equal));
    return figure;
}

Result<Figure> drawnFigure(Bench& bench) {
    Figure figure;
    figure.name = "drawn";
    figure.title = fmt::format("Sphere drawn in {0} x {0} pixels: area of the picture", kPictureSide);
    figure.settingName = "slices";
    figure.errorName = "mean distance of the outlines";
    figure.errorUnit = "pixels";
    figure.reference = fmt::format(
        "the disc's area, pi r^2 with r = {} pixels; covered pixels are counted, and the missing area is "
        "divided by the circumference. Time: upload and drawing",
        kPictureRadius);
    Curve curve{"sphere", {}};
    for (const int slices : sliceCounts(bench)) {
        const geometry::Mesh mesh = geometry::sphere(1, slices, slices / 2);
        const Result<DrawnMesh> drawn = drawMesh(bench, mesh, kPictureSide, kPictureRadius);
        if (!drawn) return drawn.diagnostics;
        const double disc = std::numbers::pi * kPictureRadius * kPictureRadius;
        curve.points.push_back(
            {.setting = static_cast<double>(slices),
             .label = fmt::format("{} slices", slices),
             .error = std::abs(drawn->area - disc) / (2 * std::numbers::pi * kPictureRadius),
             .time = drawn->time,
             .memory = meshBytes(mesh)});
    }
    figure.findings.push_back(orderSentence(curve, "slices", 8, 128));
    figure.findings.push_back(fmt::format("sphere: {} pixels at {}, where counting whole pixels is the limit",
                                          numberText(curve.points.back().error), curve.points.back().label));
    figure.curves.push_back(std::move(curve));
    return figure;
}

}  // namespace

Result<std::vector<Figure>> measurePrimitives(Bench& bench) {
    std::vector<Sweep> sweeps;
    for (const Solid& solid : solids()) {
        Sweep& sweep = sweeps.emplace_back();
        for (const int slices : sliceCounts(bench)) sweep.push_back(measureMesh(bench, solid, slices));
    }
    std::vector<Figure> teapot = teapotFigures(bench);
    std::vector<Figure> figures{positionFigure(sweeps), normalFigure(sweeps), outlineFigure(sweeps),
                                volumeFigure(sweeps), balanceFigure(bench, sweeps.front())};
    figures.push_back(triangleFigure(bench, sweeps, teapot.front()));
    for (Figure& each : teapot) figures.push_back(std::move(each));
    for (Figure& each : cutShapeFigures(bench)) figures.push_back(std::move(each));
    Result<Figure> drawn = drawnFigure(bench);
    if (drawn) figures.push_back(std::move(*drawn));
    return {std::move(figures), std::move(drawn.diagnostics)};
}

}  // namespace glibra::bench
