// The capsule against its closed forms.

#include "geometry/shapes/spheres.h"

#include <algorithm>
#include <numbers>

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

/// Distance from the segment inside the capsule, less the radius.
double distance(const glm::dvec3& p, double radius, double height) {
    const double y = std::max(0., std::abs(p.y) - height / 2);
    return std::hypot(p.x, y, p.z) - radius;
}

TEST(Capsule, HasTheStatedCounts) {
    EXPECT_EQ(countsOf(capsule(.5, 1, 60, 20)), stated(2 * 61 * 20 + 120, 4800));
    EXPECT_EQ(countsOf(capsule(1, 2, 3, 1)), stated(14, 12));
    EXPECT_EQ(countsOf(capsule(1, 2, 7, 5)), capsuleCounts(7, 5));
}

TEST(Capsule, IsClosedBitForBitAndSound) {
    for (const double radius : {1e-3, 1 / 3., 1.1, 1234.5678})
        for (const int slices : {3, 5, 6, 7, 11, 64}) {
            const Mesh mesh = capsule(radius, radius * 1.3, slices, slices + 2);
            EXPECT_EQ(openEdges(mesh), 0U) << radius << ' ' << slices;
            expectSound(mesh);
        }
    EXPECT_EQ(wronglyWound(capsule(.5, 1, 60, 20)), 0U);
}

TEST(Capsule, ItsVerticesLieOnTheSurfaceWithItsNormals) {
    const double radius = .7, height = 1.5;
    const Mesh mesh = capsule(radius, height, 24, 6);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        EXPECT_NEAR(distance(p, radius, height), 0, 1e-7);
        const glm::dvec3 onSegment(0, std::clamp(p.y, -height / 2, height / 2), 0);
        expectNear(normalAt(mesh, i), (p - onSegment) / radius);
    }
}

TEST(Capsule, VolumeConvergesToTheClosedForm) {
    const double radius = .6, height = 1.25;
    EXPECT_NEAR(volume(capsule(radius, height, 512, 128)),
                kPi * radius * radius * height + 4. / 3 * kPi * radius * radius * radius, 2e-4);
}

TEST(Capsule, TIsTheLengthAlongTheProfile) {
    const double radius = .5, height = 1, whole = kPi * radius + height;
    const Mesh mesh = capsule(radius, height, 12, 4);
    const auto tAt = [&](const glm::dvec3& place) { return texCoordAt(mesh, nearestVertex(mesh, place)).y; };
    EXPECT_NEAR(tAt({0, -1, 0}), 0, 1e-7);
    EXPECT_NEAR(tAt({0, -.5, .5}), kPi / 2 * radius / whole, 1e-6);
    EXPECT_NEAR(tAt({0, .5, .5}), (kPi / 2 * radius + height) / whole, 1e-6);
    EXPECT_NEAR(tAt({0, 1, 0}), 1, 1e-7);
    EXPECT_NEAR(texCoordAt(mesh, nearestVertex(mesh, {0, .5, .5})).x, .25, 1e-7);
    const FrameAgreement agreement = frameAgreement(capsule(.5, 1, 96, 24));
    EXPECT_GT(agreement.t, .97);
    EXPECT_GT(agreement.s, .97);
}

TEST(Capsule, ItsDeviationBoundsTheDistanceFromTheSurface) {
    for (const int slices : {3, 8, 20, 50})
        for (const int stacks : {1, 3, 9}) {
            const std::vector<double> numbers{.7, 1.5, double(slices), double(stacks)};
            const Mesh mesh = kCapsuleRow.make(numbers);
            const double inside =
                largestOnTriangles(mesh, [](const glm::dvec3& p) { return -distance(p, .7, 1.5); });
            const double bound = kCapsuleRow.deviation(numbers, Fidelity::shape);
            EXPECT_LE(inside, bound + 1e-6) << slices << ' ' << stacks;
            EXPECT_GE(inside, .5 * bound) << slices << ' ' << stacks;
        }
}

}  // namespace
}  // namespace glibra::geometry
