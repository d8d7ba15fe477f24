#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/reference/bezier_patch.h"
#include "bench/reference/mesh_error.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
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
