// Sphere, cylinder, cone, torus, box, disk and arrow: sizes, closedness, winding, frames, volumes.

#include <numbers>

#include "geometry/shapes/clouds.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/flat.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

struct Solid {
    const char* name;
    Mesh mesh;
    Counts expected;
};

std::vector<Solid> closedSolids() {
    return {{"sphere", sphere(1.7, 60, 60), stated(61 * 59 + 120, 120 * 59)},
            {"least sphere", sphere(1, 3, 2), stated(10, 6)},
            {"odd sphere", sphere(.3, 7, 5), stated(8 * 4 + 14, 14 * 4)},
            {"cylinder", cylinder(1, 1, 60, 20), stated(61 * 21 + 242, 2400 + 120)},
            {"least cylinder", cylinder(2, .1, 3, 1), stated(8 + 14, 12)},
            {"cone", cone(1, 1, 60, 20), stated(61 * 20 + 181, 2400)},
            {"least cone", cone(.7, 3, 3, 1), stated(4 + 10, 6)},
            {"odd cone", cone(.7, 3, 5, 3), stated(18 + 16, 30)},
            {"torus", torus(1, .5, 20, 40), stated(41 * 21, 1600)},
            {"least torus", torus(.25, 1, 3, 3), stated(16, 18)},
            {"odd torus", torus(1, .3, 5, 7), stated(48, 70)},
            {"box", box(2, 3, .1), stated(24, 12)},
            {"arrow", xarrow(100), stated(2648, 4848)},
            {"least arrow", xarrow(2), stated(198, 144)},
            {"odd arrow", xarrow(3), stated(223, 192)}};
}

TEST(Solids, HaveTheStatedCounts) {
    for (const Solid& solid : closedSolids()) EXPECT_EQ(countsOf(solid.mesh), solid.expected) << solid.name;
    EXPECT_EQ(countsOf(diskXY(0, 1, 60, 10)), stated(61 * 10 + 60, 60 * 19));
    EXPECT_EQ(countsOf(diskXY(0, 1, 3, 1)), (Counts{7, 3}));
}

TEST(Solids, AreAsLargeAsTheClosedFormsSay) {
    EXPECT_EQ(sphereCounts(60, 60), (Counts{3719, 7080}));
    EXPECT_EQ(countsOf(sphere(1, 11, 6)), sphereCounts(11, 6));
    EXPECT_EQ(countsOf(cylinder(1, 1, 11, 6)), cylinderCounts(11, 6));
    EXPECT_EQ(countsOf(cone(1, 1, 11, 6)), coneCounts(11, 6));
    EXPECT_EQ(countsOf(torus(1, .5, 11, 6)), torusCounts(11, 6));
    EXPECT_EQ(countsOf(diskXY(0, 1, 11, 6)), diskXYCounts(11, 6));
    EXPECT_EQ(countsOf(xarrow(13)), xarrowCounts(13));
    EXPECT_EQ(countsOf(box(1, 1, 1)), boxCounts());
}

TEST(Solids, CountsOfHugeArgumentsDoNotOverflow) {
    EXPECT_EQ(sphereCounts(9000, 9000).vertices, 81'017'999U);
    EXPECT_EQ(sphereCounts(65536, 65536).primitives, 2ULL * 65536 * 65535);
    EXPECT_EQ(cloudCounts(65536, 65536, 65536).vertices, 1ULL << 48);
}

TEST(Solids, AreClosedBitForBit) {
    for (const Solid& solid : closedSolids()) EXPECT_EQ(openEdges(solid.mesh), 0U) << solid.name;
}

TEST(Solids, AreClosedAtAwkwardSizes) {
    for (const double radius : {1e-3, .1, 1 / 3., 1.1, 1234.5678})
        for (const int slices : {3, 5, 6, 7, 11, 64}) {
            EXPECT_EQ(openEdges(sphere(radius, slices, slices)), 0U) << radius << ' ' << slices;
            EXPECT_EQ(openEdges(cylinder(radius, radius * 1.3, slices, 4)), 0U) << radius << ' ' << slices;
            EXPECT_EQ(openEdges(cone(radius, radius * 1.3, slices, 4)), 0U) << radius << ' ' << slices;
            EXPECT_EQ(openEdges(torus(radius, radius * .37, slices, slices + 1)), 0U)
                << radius << ' ' << slices;
        }
}

TEST(Solids, AreWoundCounterClockwiseFromTheirNormals) {
    for (const Solid& solid : closedSolids()) {
        if (std::string_view(solid.name).starts_with("least"))
            continue;  // facets too coarse for smooth normals
        EXPECT_EQ(wronglyWound(solid.mesh), 0U) << solid.name;
    }
    EXPECT_EQ(wronglyWound(diskXY(-2, 3, 7, 4)), 0U);
}

TEST(Solids, AreSound) {
    for (const Solid& solid : closedSolids()) {
        SCOPED_TRACE(solid.name);
        expectSound(solid.mesh);
        EXPECT_GT(volume(solid.mesh), 0);
    }
    expectSound(diskXY(-2, 3, 7, 4));
}

TEST(Solids, TangentsFollowGrowingTAndSGoesToTheirRight) {
    const std::vector<std::pair<const char*, Mesh>> meshes{
        {"sphere", sphere(1, 96, 96)}, {"cylinder", cylinder(1, 2, 96, 5)},
        {"cone", cone(1, 2, 96, 48)},  {"torus", torus(1, .4, 96, 192)},
        {"box", box(1, 2, 3)},         {"disk", diskXY(1, 2, 9, 3)},
        {"arrow", xarrow(100)}};
    for (const auto& [name, mesh] : meshes) {
        const FrameAgreement agreement = frameAgreement(mesh);
        EXPECT_GT(agreement.t, .97) << name;
        EXPECT_GT(agreement.s, .97) << name;
    }
}

TEST(Solids, VolumesConvergeToTheClosedForms) {
    EXPECT_NEAR(volume(sphere(1.5, 512, 512)), 4. / 3 * kPi * 3.375, 2e-3);
    EXPECT_NEAR(volume(cylinder(1.5, 2, 512, 3)), kPi * 2.25 * 2, 1e-3);
    EXPECT_NEAR(volume(cone(1.5, 2, 512, 3)), kPi * 2.25 * 2 / 3, 1e-3);
    EXPECT_NEAR(volume(torus(1.5, .5, 256, 512)), 2 * kPi * kPi * 1.5 * .25, 2e-3);
    EXPECT_NEAR(volume(box(2, 3, .5)), 3, 1e-6);
    // 24-sided prism and pyramid.
    const double polygon = 12 * std::sin(kPi / 12);
    EXPECT_NEAR(volume(xarrow(10)), polygon * (.0025 * 1.6 + .01 * .4 / 3), 1e-7);
}

TEST(Solids, VolumeErrorFallsWithTheSquareOfTheSubdivision) {
    const auto error = [](int n) { return 4. / 3 * kPi - volume(sphere(1, n, n)); };
    EXPECT_NEAR(error(32) / error(64), 4, .1);
}

TEST(Solids, WithoutExtentHoldNoNaN) {
    for (const Mesh& mesh :
         {sphere(0, 5, 4), cylinder(0, 1, 5, 2), cylinder(1, 0, 5, 2), cylinder(0, 0, 5, 2), cone(0, 1, 5, 2),
          cone(1, 0, 5, 2), cone(0, 0, 5, 2), torus(0, 0, 5, 5), torus(1, 0, 5, 5), box(0, 0, 0),
          wireBox(0, 0, 0), diskXY(1, 0, 5, 2)})
        expectSound(mesh);
}

TEST(Solids, HoldNoNegativeZeroInPositions) {
    for (const Solid& solid : closedSolids())
        for (const float value : solid.mesh.attribute(kPosition)->values)
            EXPECT_FALSE(value == 0 && std::signbit(value)) << solid.name;
}

}  // namespace
}  // namespace glibra::geometry
