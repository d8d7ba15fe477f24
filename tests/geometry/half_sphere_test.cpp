// The half sphere against its closed forms.

#include "geometry/shapes/spheres.h"

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

TEST(HalfSphere, HasTheStatedCounts) {
    EXPECT_EQ(countsOf(halfSphere(1, 60, 30)), stated(61 * 30 + 181, 3600));
    EXPECT_EQ(countsOf(halfSphere(1, 3, 1)), stated(14, 6));
    EXPECT_EQ(countsOf(halfSphere(1, 7, 5)), halfSphereCounts(7, 5));
}

TEST(HalfSphere, IsClosedBitForBitAndSound) {
    for (const double radius : {1e-3, 1 / 3., 1.1, 1234.5678})
        for (const int slices : {3, 5, 6, 7, 11, 64}) {
            const Mesh mesh = halfSphere(radius, slices, slices + 2);
            EXPECT_EQ(openEdges(mesh), 0U) << radius << ' ' << slices;
            expectSound(mesh);
        }
    EXPECT_EQ(wronglyWound(halfSphere(1, 60, 30)), 0U);
}

TEST(HalfSphere, VolumeConvergesToTheClosedForm) {
    EXPECT_NEAR(volume(halfSphere(1.5, 512, 256)), 2. / 3 * kPi * 3.375, 1e-3);
}

TEST(HalfSphere, IsADomeOverADisk) {
    const Mesh mesh = halfSphere(2, 24, 6);
    const std::uint32_t dome = 25 * 6 + 24;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i), st = texCoordAt(mesh, i);
        if (i < dome) {
            EXPECT_NEAR(glm::length(p), 2, 1e-6);
            expectNear(normalAt(mesh, i), p / 2.0);
            EXPECT_NEAR(std::sin(kPi / 2 * st.y) * 2, p.y, 1e-6);
        } else {
            EXPECT_EQ(p.y, 0);
            expectNear(normalAt(mesh, i), {0, -1, 0});
            expectNear(st, {.5 + p.x / 4, .5 + p.z / 4, 0});
        }
    }
    const FrameAgreement agreement = frameAgreement(halfSphere(1, 96, 48));
    EXPECT_GT(agreement.t, .97);
    EXPECT_GT(agreement.s, .97);
}

TEST(HalfSphere, ItsDeviationBoundsTheDistanceFromTheSurface) {
    for (const int slices : {3, 8, 20, 50})
        for (const int stacks : {1, 3, 9}) {
            const std::vector<double> numbers{1.5, double(slices), double(stacks)};
            Mesh mesh = kHalfSphereRow.make(numbers);
            // The dome alone: the disk is flat.
            mesh.indices.resize(mesh.indices.size() - 3 * static_cast<std::size_t>(slices));
            const double inside =
                largestOnTriangles(mesh, [](const glm::dvec3& p) { return 1.5 - glm::length(p); });
            const double bound = kHalfSphereRow.deviation(numbers, Fidelity::shape);
            EXPECT_LE(inside, bound + 1e-6) << slices << ' ' << stacks;
            EXPECT_GE(inside, .5 * bound) << slices << ' ' << stacks;
        }
}

}  // namespace
}  // namespace glibra::geometry
