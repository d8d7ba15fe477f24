#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bench/core/figure.h"
#include "bench/reference/surfaces.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

constexpr std::array<glm::dvec3, 3> kCorners{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(PnTriangle, GoesThroughItsCornersAndTheirTangentPlanes) {
    const PnTriangle triangle(kCorners, kCorners);
    EXPECT_EQ(triangle.at({1, 0, 0}), kCorners[0]);
    EXPECT_EQ(triangle.at({0, 0, 1}), kCorners[2]);
    constexpr double kStep = 1e-6;
    const glm::dvec3 moved = triangle.at({1 - kStep, kStep, 0}) - triangle.at({1, 0, 0});
    EXPECT_NEAR(glm::dot(moved / kStep, kCorners[0]), 0, 1e-5);
}

TEST(PnTriangle, ItsMiddleOnAnOctantIsFourNinthsInEveryCoordinate) {
    // Six tangent points with the mean 4/9 and corners with the mean 1/3: b111 = 1/2, middle (1 + 8 + 3) /
    // 27.
    const glm::dvec3 middle = PnTriangle(kCorners, kCorners).at(glm::dvec3(1. / 3));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(middle[i], 4. / 9, 1e-15);
}

TEST(PnTriangle, AFlatTriangleGivesHeightsAsDistances) {
    const std::array<glm::dvec3, 3> corners{{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}};
    const std::array<glm::dvec3, 3> normals{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    EXPECT_NEAR(PnTriangle(corners, normals).distance({.5, .7, .25}, {.4, .3, .3}), .25, 1e-12);
}

using Tessellation = FiguresOf<measureTessellation>;

TEST_F(Tessellation, DistancesFallWithTheSquareOfTheLevelInEverySpacing) {
    for (const char* name : {"bezier-largest", "bezier-mean", "sphere-largest", "sphere-mean",
                             "pn-triangle-largest", "pn-triangle-mean"})
        for (const Curve& curve : figure(name).curves)
            EXPECT_NEAR(fittedOrder(curve, 8), -2, .2) << name << ", " << curve.name;
}

TEST_F(Tessellation, OneTriangleOfAnOctantMissesTheSphereByWhatItsMiddleSays) {
    // Sampled on a grid of quarters, which does not contain the middle: the nearest points are (1/2, 1/4,
    // 1/4).
    const Point& first = figure("sphere-largest").curves.front().points.front();
    EXPECT_NEAR(first.error, 1 - std::sqrt(.25 + .0625 + .0625), 1e-6);
}

TEST_F(Tessellation, SymmetricSumsLeaveNoCrackAndOneSidedOnesDo) {
    for (const Curve& curve : figure("cracks").curves) {
        double all = 0;
        for (const Point& point : curve.points) all += point.error;
        if (curve.name.starts_with("symmetric")) {
            EXPECT_EQ(all, 0) << curve.name;
        } else {
            EXPECT_GT(all, 0) << curve.name;
        }
    }
}

TEST_F(Tessellation, NeighboursOfDifferentLevelsLeaveGapsThatShrinkWithTheSquare) {
    for (const Curve& curve : figure("level-gaps").curves)
        EXPECT_NEAR(fittedOrder(curve, 4), -2, .4) << curve.name;
}

TEST_F(Tessellation, TheSpacingsDivideAsTheirNamesSay) {
    // Rings of triangles around the middle: 3 (4 + 2) + 3 * 2 with 4 segments on an edge. An odd spacing
    // makes 5 of level 4: 3 (5 + 3) + 3 (3 + 1) + 1.
    for (const auto& [spacing, triangles] : {std::pair("equal spacing", "level 4, 24 triangles"),
                                             {"fractional even spacing", "level 4, 24 triangles"},
                                             {"fractional odd spacing", "level 4, 37 triangles"}})
        EXPECT_EQ(curve("sphere-largest", spacing).points[2].label, triangles) << spacing;
}

}  // namespace
}  // namespace glibra::bench::test
