#include "bench/reference/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "bench/reference/triangle_net.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/spheres.h"

namespace glibra::bench {
namespace {

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

}  // namespace

std::span<const Solid> solids() {
    return kSolids;
}

MeshError meshError(const geometry::Mesh& mesh, Foot (*foot)(const glm::dvec3&, const glm::dvec3&)) {
    MeshError largest;
    forEachTriangle(mesh, 6, [&](const Triangle& triangle, const glm::dvec3& weights) {
        const Foot at = foot(triangle.position(weights) / kSolidRadius, triangle.faceNormal);
        largest.distance = std::max(largest.distance, at.distance);
        if (!at.hasNormal) return;
        largest.normal = std::max(largest.normal, degreesBetween(triangle.normal(weights), at.normal));
        largest.faceNormal = std::max(largest.faceNormal, degreesBetween(triangle.faceNormal, at.normal));
    });
    return largest;
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
            const double angle = 2 * kPi * i * std::numbers::phi;
            const glm::dvec3 direction = std::cos(angle) * right + std::sin(angle) * up;
            double farthest = -1e300;
            for (const glm::dvec3& p : positions) farthest = std::max(farthest, glm::dot(p, direction));
            largest = std::max(largest, std::abs(farthest / kSolidRadius - extent(direction)));
        }
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

}  // namespace glibra::bench
