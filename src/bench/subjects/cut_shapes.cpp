#include "bench/subjects/cut_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <string>

#include "bench/core/fit.h"
#include "bench/reference/bezier_surface.h"
#include "bench/reference/solids.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

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

Point cutPoint(const Bench& bench, const CutShape& shape, const geometry::Mesh& mesh, int cells,
               double error) {
    return {.setting = static_cast<double>(cells),
            .label = fmt::format("{} cells along an edge", cells),
            .error = error,
            .time = bench.time([&] { shape.mesh(cells); }),
            .memory = meshBytes(mesh)};
}

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

std::vector<Figure> cutShapeFigures(const Bench& bench) {
    const TeapotPatches patches = placedTeapotPatches();
    const std::vector<CutShape> shapes{
        {"soccer ball", [](int cells) { return geometry::soccerball(kSolidRadius, cells); },
         [](const glm::dvec3&) { return 1.; }, 4 * std::numbers::pi / 3, kSolidRadius},
        {"teapot", [](int cells) { return geometry::teapot(cells); }, PatchExtent(patches),
         patchVolume(patches), 1}};
    Figure distance =
        cutFigure("ball-position", "Soccer ball: distance of the mesh from the surface", "largest distance",
                  "radii", "the sphere in closed form, at a net of 28 points on every triangle");
    Figure normal = cutFigure("ball-normal", "Soccer ball: interpolated normals", "largest angle", "degrees",
                              "the radius at the same places");
    Figure outline =
        cutFigure("cut-outline",
                  fmt::format("Soccer ball and teapot: outline, a radius being {} pixels", kOutlineRadius),
                  "largest distance of the outlines", "pixels",
                  "the extent in 360 directions of three views: of the sphere, and of the patches by a "
                  "search in double");
    Figure volume = cutFigure("cut-volume", "Soccer ball and teapot: volume", "relative error", "",
                              "the sphere's, and the patches' by Gauss's quadrature, which is exact for "
                              "them; the meshes' by the divergence theorem");
    const std::vector<int> counts =
        bench.isQuick() ? std::vector{2, 4, 8} : std::vector{2, 3, 4, 6, 8, 12, 16, 24, 32};
    for (const CutShape& shape : shapes) {
        Curve distances{shape.name, {}}, normals = distances, outlines = distances, volumes = distances;
        for (const int cells : counts) {
            const geometry::Mesh mesh = shape.mesh(cells);
            Point point = cutPoint(bench, shape, mesh, cells, 0);
            const auto add = [&](Curve& curve, double error) {
                point.error = error;
                curve.points.push_back(point);
            };
            if (shape.unit != 1) {
                const MeshError found = sphereError(mesh);
                add(distances, found.distance);
                add(normals, found.normal);
            }
            // The measures of the solids assume a mesh of size kSolidRadius.
            const double scale = kSolidRadius / shape.unit;
            add(outlines, kOutlineRadius * outlineError(mesh, [&](const glm::dvec3& direction) {
                              return shape.extent(direction) / scale;
                          }) * scale);
            add(volumes, std::abs(std::abs(signedVolume(mesh)) * std::pow(scale, 3) / shape.volume - 1));
        }
        for (auto& [figure, curve] : {std::pair(&distance, &distances),
                                      {&normal, &normals},
                                      {&outline, &outlines},
                                      {&volume, &volumes}}) {
            if (curve->points.empty()) continue;
            figure->findings.push_back(figure == &normal ? angleSentence(*curve, "cells", 3)
                                                         : orderSentence(*curve, "cells", 3));
            figure->curves.push_back(std::move(*curve));
        }
    }
    return {std::move(distance), std::move(normal), std::move(outline), std::move(volume)};
}

}  // namespace glibra::bench
