#include "bench/subjects/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/core/device.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

/// Three components of an attribute of every vertex, in double; missing components are 0.
std::vector<glm::dvec3> vectorsOf(const geometry::Mesh& mesh, std::string_view name) {
    const geometry::Attribute* attribute = mesh.attribute(name);
    if (!attribute) return {};
    const auto components = static_cast<std::size_t>(attribute->components);
    std::vector<glm::dvec3> vectors(attribute->values.size() / components);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t c = 0; c < components && c < 3; ++c)
            vectors[i][static_cast<glm::length_t>(c)] = attribute->values[i * components + c];
    return vectors;
}

std::vector<glm::dvec3> positionsOf(const geometry::Mesh& mesh) {
    return vectorsOf(mesh, geometry::kPosition);
}

/// Interpolates linearly, as the pipeline does.
struct Triangle {
    std::array<std::uint32_t, 3> vertices{};
    std::array<glm::dvec3, 3> positions{}, normals{}, texCoords{};
    glm::dvec3 faceNormal{0};  ///< unit length

    [[nodiscard]] glm::dvec3 position(const glm::dvec3& weights) const { return mixed(positions, weights); }
    /// Normalised.
    [[nodiscard]] glm::dvec3 normal(const glm::dvec3& weights) const {
        return glm::normalize(mixed(normals, weights));
    }
    [[nodiscard]] glm::dvec2 texCoord(const glm::dvec3& weights) const { return mixed(texCoords, weights); }

  private:
    static glm::dvec3 mixed(const std::array<glm::dvec3, 3>& of, const glm::dvec3& weights) {
        return weights[0] * of[0] + weights[1] * of[1] + weights[2] * of[2];
    }
};

/// Calls visit(const Triangle&, const glm::dvec3& weights) at (cells + 1)(cells + 2) / 2 points of every
/// triangle that has an area, including its corners and edges. The mesh has normals and texture coordinates.
template <class Visit>
void forEachTriangle(const geometry::Mesh& mesh, int cells, const Visit& visit) {
    const std::vector<glm::dvec3> positions = positionsOf(mesh), normals = vectorsOf(mesh, geometry::kNormal),
                                  texCoords = vectorsOf(mesh, geometry::kTexCoord);
    for (std::size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
        Triangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex = mesh.indices[first + i];
            triangle.vertices[i] = vertex;
            triangle.positions[i] = positions[vertex];
            triangle.normals[i] = normals[vertex];
            triangle.texCoords[i] = texCoords[vertex];
        }
        const glm::dvec3 across = glm::cross(triangle.positions[1] - triangle.positions[0],
                                             triangle.positions[2] - triangle.positions[0]);
        const double area = glm::length(across);
        if (!(area > 0)) continue;
        triangle.faceNormal = across / area;
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; i + j <= cells; ++j)
                visit(triangle, glm::dvec3(i, j, cells - i - j) / static_cast<double>(cells));
    }
}

/// 0..180 degrees; accurate for small angles too.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

constexpr double kTube = .4, kSolidHeight = 2;
constexpr double kApex = 1e-6;  ///< nearer to its axis, a cone has no normal
constexpr double kPi = std::numbers::pi;

Foot footOnSphere(const glm::dvec3& p, const glm::dvec3& /*face*/) {
    const double length = glm::length(p);
    return {std::abs(length - 1), p / length};
}

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

/// A solid in closed form.
struct Solid {
    const char* name;
    /// The mesh with n slices around (n >= 6). Stacks and sides are n / 2; cylinder and cone have 1.
    geometry::Mesh (*mesh)(int n);
    FootOn foot;
    double volume;
    /// The largest dot(p, direction) over the solid (support function), for a unit direction.
    double (*extent)(const glm::dvec3& direction);
};
constexpr Solid kSolids[] = {
    {"sphere", [](int n) { return geometry::sphere(kSolidRadius, n, n / 2); }, footOnSphere, 4 * kPi / 3,
     [](const glm::dvec3&) { return 1.; }},
    {"torus", [](int n) { return geometry::torus(kSolidRadius, kTube * kSolidRadius, n / 2, n); },
     footOnTorus, 2 * kPi* kPi* kTube* kTube,
     [](const glm::dvec3& d) { return std::hypot(d.x, d.y) + kTube; }},
    {"cylinder", [](int n) { return geometry::cylinder(kSolidRadius, kSolidHeight * kSolidRadius, n, 1); },
     footOnCylinder, kPi* kSolidHeight,
     [](const glm::dvec3& d) { return std::hypot(d.x, d.z) + std::max(0., kSolidHeight * d.y); }},
    {"cone", [](int n) { return geometry::cone(kSolidRadius, kSolidHeight * kSolidRadius, n, 1); },
     footOnCone, kPi* kSolidHeight / 3,
     [](const glm::dvec3& d) { return std::max(std::hypot(d.x, d.z), kSolidHeight * d.y); }},
};

constexpr double kOutlineRadius = 512;  ///< pixels of a radius where outlines are compared

/// The largest distance between the outlines of mesh and solid in three views without perspective: the
/// largest difference of the extents of their convex hulls in 360 directions per view.
double outlineError(const geometry::Mesh& mesh, const std::function<double(const glm::dvec3&)>& extent) {
    constexpr int kDirections = 360;
    const std::vector<glm::dvec3> positions = positionsOf(mesh);
    const std::array<std::array<glm::dvec3, 2>, 3> views{{
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)},
        {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)},
        {glm::dvec3(.6, .48, .64), glm::dvec3(0, .8, -.6)},
    }};
    double largest = 0;
    for (const auto& [right, up] : views)
        for (int i = 0; i < kDirections; ++i) {
            // The golden section spreads the directions so that they meet slices at every phase.
            const double angle = 2 * kPi * i * std::numbers::phi;
            const glm::dvec3 direction = std::cos(angle) * right + std::sin(angle) * up;
            double farthest = -1e300;
            for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::dot(p, direction));
            largest = std::max(largest, std::abs(farthest / kSolidRadius - extent(direction)));
        }
    return largest;
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
    int slices = 0;
    double triangles = 0, bytes = 0, outline = 0, volume = 0;
    MeshError error;
    Timing time;
};
using Sweep = std::vector<MeasuredMesh>;

Sweep measuredSweep(const Bench& bench, const Solid& solid) {
    Sweep sweep;
    for (const int slices : sliceCounts(bench)) {
        const geometry::Mesh mesh = solid.mesh(slices);
        sweep.push_back({slices, static_cast<double>(mesh.indices.size()) / 3, meshBytes(mesh),
                         outlineError(mesh, solid.extent) * kOutlineRadius,
                         std::abs(signedVolume(mesh) / solid.volume - 1), meshError(mesh, solid.foot),
                         bench.time([&] { solid.mesh(slices); })});
    }
    return sweep;
}

void addSweep(Figure& figure, const char* curve, const Sweep& sweep, double (*error)(const MeasuredMesh&)) {
    for (const MeasuredMesh& each : sweep)
        figure.add(curve, {1. * each.slices, slicesLabel(each.slices), error(each), each.time, each.bytes});
}

/// One measure of all solids by their slices.
Figure bySlices(std::span<const Sweep> sweeps, double (*error)(const MeasuredMesh&), Figure figure) {
    figure.settingName = "slices";
    figure.alternatives = Alternatives::curve;
    for (std::size_t i = 0; i < sweeps.size(); ++i) addSweep(figure, kSolids[i].name, sweeps[i], error);
    return figure;
}

double distanceOf(const MeasuredMesh& mesh) {
    return mesh.error.distance;
}

Figure positionFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, distanceOf,
                             {.name = "position",
                              .title = "Distance of the mesh from the surface",
                              .errorName = "largest distance",
                              .errorUnit = "radii",
                              .reference = kClosedForm});
    figure.noteOrders("slices", 8);
    return figure;
}

Figure normalFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(sweeps, [](const MeasuredMesh& each) { return each.error.normal; },
                             {.name = "normal",
                              .title = "Interpolated normals, and the normals of flat triangles",
                              .errorName = "largest angle",
                              .errorUnit = "degrees",
                              .reference = kClosedForm});
    addSweep(figure, "sphere, flat triangles", sweeps.front(),
             [](const MeasuredMesh& each) { return each.error.faceNormal; });
    for (const Curve& each : figure.curves) figure.findings.push_back(angleSentence(each, "slices", 8));
    figure.note(
        "sphere, {}: interpolated normals are within {} degrees of the radius, flat triangles {} degrees "
        "off",
        figure.last(0).label, numberText(figure.last(0).error),
        numberText(figure.curves.back().points.back().error));
    return figure;
}

Figure outlineFigure(std::span<const Sweep> sweeps) {
    Figure figure = bySlices(
        sweeps, [](const MeasuredMesh& each) { return each.outline; },
        {.name = "outline",
         .title = fmt::format("Outline, where the radius is {} pixels", kOutlineRadius),
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
        bySlices(sweeps, [](const MeasuredMesh& each) { return each.volume; },
                 {.name = "volume",
                  .title = "Volume",
                  .errorName = "relative error",
                  .reference = "the volume in closed form; the mesh's by the divergence theorem, in double"});
    figure.noteOrders("slices", 8);
    return figure;
}

/// Slices with a fixed number of stacks: where more slices stop helping, stacks are missing.
Figure balanceFigure(const Bench& bench, const Sweep& balanced) {
    Figure figure{.name = "balance",
                  .title = "Sphere: slices with too few stacks",
                  .settingName = "slices",
                  .errorName = "largest distance",
                  .errorUnit = "radii",
                  .reference = kClosedForm};
    addSweep(figure, "stacks = slices / 2", balanced, distanceOf);
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
    const auto add = [&](const char* curve, double triangles, double error, const Timing& time,
                         double bytes) {
        figure.add(curve, {triangles, fmt::format("{:.0f} triangles", triangles), error, time, bytes});
    };
    for (std::size_t i = 0; i < sweeps.size(); ++i)
        for (const MeasuredMesh& each : sweeps[i])
            add(kSolids[i].name, each.triangles, each.error.distance, each.time, each.bytes);
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

using TeapotPatches = std::array<geometry::Patch, 32>;

/// The patches of the teapot at their places in the meshes of scenes, whose body is two units wide.
TeapotPatches placedTeapotPatches() {
    TeapotPatches patches = geometry::teapotPatches();
    for (geometry::Patch& patch : patches)
        for (auto& row : patch)
            for (glm::dvec3& point : row) point = geometry::teapotPlace(point);
    return patches;
}

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

std::vector<Figure> teapotFigures(const Bench& bench, const TeapotPatches& patches) {
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

/// The volume between the patches and the origin, which also exists for the teapot although it is open: the
/// integral of P . (Ps x Pt) / 3, a polynomial of degree 8 in s and in t, for which five Gauss points are
/// exact.
double patchVolume(const TeapotPatches& patches) {
    constexpr std::array<std::array<double, 2>, 5> kGauss{{{-.9061798459386640, .2369268850561891},
                                                           {-.5384693101056831, .4786286704993665},
                                                           {0, .5688888888888889},
                                                           {.5384693101056831, .4786286704993665},
                                                           {.9061798459386640, .2369268850561891}}};
    double sum = 0;
    for (const geometry::Patch& patch : patches)
        for (const auto& [s, weightS] : kGauss)
            for (const auto& [t, weightT] : kGauss) {
                const PatchPoint at = patchPoint(patch, {(s + 1) / 2, (t + 1) / 2});
                sum += weightS * weightT / 4 * glm::dot(at.position, glm::cross(at.alongS, at.alongT)) / 3;
            }
    return std::abs(sum);
}

/// The extent of the patches in a direction: the best of 17 x 17 points of each patch, refined by ever
/// smaller steps.
class PatchExtent {
  public:
    explicit PatchExtent(const TeapotPatches& patches) : patches_(patches) {
        for (std::size_t patch = 0; patch < patches.size(); ++patch)
            for (int j = 0; j <= kCells; ++j)
                for (int i = 0; i <= kCells; ++i) {
                    const glm::dvec2 st = glm::dvec2(i, j) / static_cast<double>(kCells);
                    places_.push_back({patch, st, patchPoint(patches[patch], st).position});
                }
    }

    [[nodiscard]] double operator()(const glm::dvec3& direction) const {
        const Place& best = *std::ranges::max_element(
            places_, {}, [&](const Place& each) { return glm::dot(each.position, direction); });
        glm::dvec2 at = best.st;
        double farthest = glm::dot(best.position, direction);
        for (double step = 1. / kCells; step > 1e-7;) {
            bool isBetter = false;
            for (const glm::dvec2 side : {glm::dvec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const glm::dvec2 there = glm::clamp(at + step * side, 0., 1.);
                const double reach = glm::dot(patchPoint(patches_[best.patch], there).position, direction);
                if (reach <= farthest) continue;
                farthest = reach;
                at = there;
                isBetter = true;
            }
            if (!isBetter) step /= 2;
        }
        return farthest;
    }

  private:
    static constexpr int kCells = 16;
    struct Place {
        std::size_t patch = 0;
        glm::dvec2 st{0};
        glm::dvec3 position{0};
    };
    const TeapotPatches& patches_;
    std::vector<Place> places_;
};

struct CutShape {
    std::string name;
    std::function<geometry::Mesh(int cells)> mesh;
    std::function<double(const glm::dvec3& direction)> extent;
    double volume = 0;  ///< cubed units
    double unit = 1;    ///< size of the mesh, in the units of extent and volume
};

Figure cutFigure(std::string name, std::string title, std::string error, std::string unit,
                 std::string reference) {
    return {.name = std::move(name),
            .title = std::move(title),
            .settingName = "cells along an edge",
            .errorName = std::move(error),
            .errorUnit = std::move(unit),
            .reference = std::move(reference),
            .alternatives = Alternatives::curve};
}

/// Soccer ball and teapot by the number of cells along an edge of their faces or patches: distance and
/// normals of the ball; outline and volume of both.
std::vector<Figure> cutShapeFigures(const Bench& bench, const TeapotPatches& patches) {
    const CutShape shapes[] = {
        {"soccer ball", [](int cells) { return geometry::soccerball(kSolidRadius, cells); },
         [](const glm::dvec3&) { return 1.; }, 4 * kPi / 3, kSolidRadius},
        {"teapot", [](int cells) { return geometry::teapot(cells); }, PatchExtent(patches),
         patchVolume(patches), 1}};
    std::vector<Figure> figures{
        cutFigure("ball-position", "Soccer ball: distance of the mesh from the surface", "largest distance",
                  "radii", "the sphere in closed form, at a net of 28 points on every triangle"),
        cutFigure("ball-normal", "Soccer ball: interpolated normals", "largest angle", "degrees",
                  "the radius at the same places"),
        cutFigure("cut-outline",
                  fmt::format("Soccer ball and teapot: outline, a radius being {} pixels", kOutlineRadius),
                  "largest distance of the outlines", "pixels",
                  "the extent in 360 directions of three views: of the sphere, and of the patches by a "
                  "search in double"),
        cutFigure("cut-volume", "Soccer ball and teapot: volume", "relative error", "",
                  "the sphere's, and the patches' by Gauss's quadrature, which is exact for "
                  "them; the meshes' by the divergence theorem")};
    for (const CutShape& shape : shapes)
        for (const int cells : bench.pick(std::vector{2, 4, 8}, {2, 3, 4, 6, 8, 12, 16, 24, 32})) {
            const geometry::Mesh mesh = shape.mesh(cells);
            Point point{1. * cells, fmt::format("{} cells along an edge", cells), 0,
                        bench.time([&] { shape.mesh(cells); }), meshBytes(mesh)};
            const auto add = [&](std::size_t figure, double error) {
                point.error = error;
                figures[figure].add(shape.name, point);
            };
            if (shape.unit != 1) {
                const MeshError found = sphereError(mesh);
                add(0, found.distance);
                add(1, found.normal);
            }
            // The measures of the solids assume a mesh of size kSolidRadius.
            const double scale = kSolidRadius / shape.unit;
            add(2, kOutlineRadius * outlineError(mesh, [&](const glm::dvec3& direction) {
                       return shape.extent(direction) / scale;
                   }) * scale);
            add(3, std::abs(std::abs(signedVolume(mesh)) * std::pow(scale, 3) / shape.volume - 1));
        }
    for (Figure& figure : figures)
        for (const Curve& curve : figure.curves)
            figure.findings.push_back(figure.errorUnit == "degrees" ? angleSentence(curve, "cells", 3)
                                                                    : orderSentence(curve, "cells", 3));
    return figures;
}

using FourPoints = std::array<glm::dvec3, 4>;

struct CurvePoint {
    glm::dvec3 position{0}, slope{0};
};

CurvePoint deCasteljau(FourPoints p, double u) {
    for (std::size_t level = 3; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = glm::mix(p[i], p[i + 1], u);
    return {glm::mix(p[0], p[1], u), 3. * (p[1] - p[0])};
}

}  // namespace

MeshError meshError(const geometry::Mesh& mesh, FootOn foot) {
    MeshError largest;
    forEachTriangle(mesh, 6, [&](const Triangle& triangle, const glm::dvec3& weights) {
        const Foot at = foot(triangle.position(weights) / kSolidRadius, triangle.faceNormal);
        largest.distance = std::max(largest.distance, at.distance);
        if (!at.hasNormal) return;
        largest.normal = std::max(largest.normal, angleBetween(triangle.normal(weights), at.normal));
        largest.faceNormal = std::max(largest.faceNormal, angleBetween(triangle.faceNormal, at.normal));
    });
    return largest;
}

MeshError sphereError(const geometry::Mesh& mesh) {
    return meshError(mesh, footOnSphere);
}

double signedVolume(const geometry::Mesh& mesh) {
    const std::vector<glm::dvec3> p = positionsOf(mesh);
    double six = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        six += glm::dot(p[mesh.indices[i]], glm::cross(p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]));
    return six / (6 * kSolidRadius * kSolidRadius * kSolidRadius);
}

double meshBytes(const geometry::Mesh& mesh) {
    std::size_t values = mesh.indices.size();
    for (const geometry::Attribute& each : mesh.attributes) values += each.values.size();
    return 4. * static_cast<double>(values);
}

PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st) {
    FourPoints columns, slopes;
    for (std::size_t column = 0; column < 4; ++column) {
        const CurvePoint down =
            deCasteljau({patch[0][column], patch[1][column], patch[2][column], patch[3][column]}, st.y);
        columns[column] = down.position;
        slopes[column] = down.slope;
    }
    const CurvePoint across = deCasteljau(columns, st.x);
    return {across.position, across.slope, deCasteljau(slopes, st.x).position};
}

glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start) {
    constexpr int kSteps = 4;
    constexpr double kDamping = 1e-9;  // prevents a division by 0 at the poles, where dP/ds is 0
    glm::dvec2 st = start;
    for (int i = 0; i < kSteps; ++i) {
        const PatchPoint at = patchPoint(patch, st);
        const glm::dvec3 miss = point - at.position;
        const double ss = glm::dot(at.alongS, at.alongS) + kDamping,
                     tt = glm::dot(at.alongT, at.alongT) + kDamping, mixed = glm::dot(at.alongS, at.alongT);
        const double s = glm::dot(at.alongS, miss), t = glm::dot(at.alongT, miss);
        const double determinant = ss * tt - mixed * mixed;
        const glm::dvec2 step((tt * s - mixed * t) / determinant, (ss * t - mixed * s) / determinant);
        st = glm::clamp(st + step, 0., 1.);
    }
    return st;
}

std::vector<Figure> measurePrimitives(Bench& bench) {
    std::vector<Sweep> sweeps;
    for (const Solid& solid : kSolids) sweeps.push_back(measuredSweep(bench, solid));
    const TeapotPatches patches = placedTeapotPatches();
    std::vector<Figure> teapot = teapotFigures(bench, patches);
    std::vector<Figure> figures{positionFigure(sweeps),
                                normalFigure(sweeps),
                                outlineFigure(sweeps),
                                volumeFigure(sweeps),
                                balanceFigure(bench, sweeps.front()),
                                triangleFigure(bench, sweeps, teapot.front())};
    std::ranges::move(teapot, std::back_inserter(figures));
    std::ranges::move(cutShapeFigures(bench, patches), std::back_inserter(figures));
    bench.attempt([&] { figures.push_back(drawnFigure(bench)); });
    return figures;
}

}  // namespace glibra::bench
