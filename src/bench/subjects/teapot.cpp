#include "bench/subjects/teapot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "bench/core/fit.h"
#include "bench/reference/bezier_surface.h"
#include "bench/reference/solids.h"
#include "bench/reference/triangle_net.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {
namespace {

constexpr int kShippedCells = 16;

geometry::Attribute attribute(std::string_view name, int components) {
    return {std::string(name), components, {}};
}

/// A grid on every patch, rounded once to float, with (cells + 1)^2 vertices per patch.
geometry::Mesh patchGrid(const TeapotPatches& patches, int cells) {
    geometry::Attribute positions = attribute(geometry::kPosition, 3),
                        normals = attribute(geometry::kNormal, 3),
                        texCoords = attribute(geometry::kTexCoord, 2);
    geometry::Mesh mesh;
    const auto stride = static_cast<std::uint32_t>(cells + 1);
    const auto append = [](geometry::Attribute& to, const glm::dvec3& value) {
        for (int i = 0; i < to.components; ++i) to.values.push_back(static_cast<float>(value[i]));
    };
    for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const glm::dvec2 st(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
                const PatchPoint at = patchPoint(patches[patch], st);
                const glm::dvec3 across = glm::cross(at.alongS, at.alongT);
                const double length = glm::length(across);
                append(positions, at.position);
                append(normals, length > 1e-12 ? across / length : glm::dvec3(0, j == 0 ? -1 : 1, 0));
                append(texCoords, {st, 0});
            }
        for (std::uint32_t j = 0; j + 1 < stride; ++j)
            for (std::uint32_t i = 0; i + 1 < stride; ++i) {
                const std::uint32_t a = patch * stride * stride + j * stride + i;
                for (const std::uint32_t index : {a, a + 1, a + stride + 1, a, a + stride + 1, a + stride})
                    mesh.indices.push_back(index);
            }
    }
    mesh.attributes = {std::move(positions), std::move(normals), std::move(texCoords)};
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
        const double angle = degreesBetween(triangle.normal(weights), glm::normalize(across));
        if (angle > largest.normal) {
            largest.normal = angle;
            largest.normalAt = partOf(number);
        }
    });
    return largest;
}

Point teapotPoint(const geometry::Mesh& mesh, int cells, double error, const Timing& time) {
    return {.setting = static_cast<double>(cells),
            .label = fmt::format("{0} x {0} cells", cells),
            .error = error,
            .time = time,
            .memory = meshBytes(mesh)};
}

}  // namespace

std::vector<Figure> teapotFigures(const Bench& bench) {
    const TeapotPatches patches = placedTeapotPatches();
    Figure position;
    position.name = "teapot-position";
    position.title = "Teapot: distance of the mesh from the patches";
    position.settingName = "cells per side of a patch";
    position.errorName = "largest distance";
    position.errorUnit = "radii";
    position.reference =
        "the 32 bicubic patches by de Casteljau's algorithm in double, at the nearest point that "
        "Gauss-Newton "
        "steps find";
    Figure normal = position;
    normal.name = "teapot-normal";
    normal.title = "Teapot: interpolated normals";
    normal.errorName = "largest angle";
    normal.errorUnit = "degrees";

    Curve positions{"grid on every patch", {}}, normals = positions;
    const std::vector<int> counts = bench.isQuick() ? std::vector{4, 8} : std::vector{2, 4, 8, 16, 32};
    for (const int cells : counts) {
        const geometry::Mesh mesh = patchGrid(patches, cells);
        const TeapotError found = errorOf(mesh, patches, cells);
        const Timing time = bench.time([&] { patchGrid(patches, cells); });
        positions.points.push_back(teapotPoint(mesh, cells, found.distance, time));
        normals.points.push_back(teapotPoint(mesh, cells, found.normal, time));
    }
    const geometry::Mesh shipped = geometry::teapot();
    const TeapotError found = errorOf(shipped, patches, kShippedCells);
    const Timing time = bench.time([] { geometry::teapot(); });
    position.findings = {orderSentence(positions, "cells"),
                         fmt::format("the teapot of scenes is {} radii from its patches, farthest at the {}",
                                     numberText(found.distance), found.distanceAt)};
    normal.findings = {
        orderSentence(normals, "cells"),
        fmt::format("the teapot of scenes: {} degrees, at the {}", numberText(found.normal), found.normalAt)};
    position.curves = {std::move(positions),
                       {"the teapot of scenes", {teapotPoint(shipped, kShippedCells, found.distance, time)}}};
    normal.curves = {std::move(normals),
                     {"the teapot of scenes", {teapotPoint(shipped, kShippedCells, found.normal, time)}}};
    return {std::move(position), std::move(normal)};
}

}  // namespace glibra::bench
