#include "bench/subjects/mesh_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glibra::bench {
namespace {

std::vector<glm::dvec3> positionsOf(const geometry::Mesh& mesh) {
    return vectorsOf(mesh, geometry::kPosition);
}

}  // namespace

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

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

Foot footOnSphere(const glm::dvec3& p, const glm::dvec3& /*face*/) {
    const double length = glm::length(p);
    return {std::abs(length - 1), p / length};
}

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
            const double angle = 2 * std::numbers::pi * i * std::numbers::phi;
            const glm::dvec3 direction = std::cos(angle) * right + std::sin(angle) * up;
            double farthest = -1e300;
            for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::dot(p, direction));
            largest = std::max(largest, std::abs(farthest / kSolidRadius - extent(direction)));
        }
    return largest;
}

}  // namespace glibra::bench
