#include "bench/subjects/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/subjects/mesh_error.h"
#include "geometry/shapes/polyhedra.h"

namespace glibra::bench {
namespace {

using FourPoints = std::array<glm::dvec3, 4>;

struct CurvePoint {
    glm::dvec3 position{0}, slope{0};
};

CurvePoint deCasteljau(FourPoints p, double u) {
    for (std::size_t level = 3; level > 1; --level)
        for (std::size_t i = 0; i < level; ++i) p[i] = glm::mix(p[i], p[i + 1], u);
    return {glm::mix(p[0], p[1], u), 3. * (p[1] - p[0])};
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

}  // namespace

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

std::vector<Figure> cutShapeFigures(const Bench& bench) {
    const TeapotPatches patches = placedTeapotPatches();
    const CutShape shapes[] = {
        {"soccer ball", [](int cells) { return geometry::soccerball(kSolidRadius, cells); },
         [](const glm::dvec3&) { return 1.; }, 4 * std::numbers::pi / 3, kSolidRadius},
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

}  // namespace glibra::bench
