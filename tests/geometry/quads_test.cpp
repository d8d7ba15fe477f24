// Squares and point clouds.

#include <algorithm>

#include "geometry/mix.h"
#include "geometry/shapes/clouds.h"
#include "geometry/shapes/flat.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

TEST(FullScreen, IsTheSquareOfClipSpace) {
    const Mesh mesh = kFullScreenRow.make({});
    EXPECT_EQ(mesh.attribute(kPosition)->values,
              (std::vector<float>{-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0}));
    EXPECT_EQ(mesh.attribute(kTexCoord)->values, (std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1}));
}

TEST(Quads, HaveTheStatedCounts) {
    EXPECT_EQ(countsOf(quadXY(0, 1, 4, 4)), (Counts{25, 32}));
    EXPECT_EQ(countsOf(quadXZ(0, 1, 1, 3)), (Counts{8, 6}));
    EXPECT_EQ(countsOf(quadYZ(0, 1, 3, 1)), (Counts{8, 6}));
    EXPECT_EQ(countsOf(quadXY(0, 1, 7, 5)), quadCounts(7, 5));
    EXPECT_EQ(countsOf(quadBox(10)), (Counts{40, 20}));
    EXPECT_EQ(countsOf(quadBox(1)), quadBoxCounts(1));
}

TEST(Quads, FaceThePositiveAxisOnBothSides) {
    for (const double at : {-2., 0., 2.})
        for (const Mesh& mesh : {quadXY(at, 3, 2, 5), quadXZ(at, 3, 2, 5), quadYZ(at, 3, 2, 5)}) {
            EXPECT_EQ(wronglyWound(mesh), 0U);
            expectSound(mesh);
            const glm::dvec3 n = normalAt(mesh, 0);
            EXPECT_EQ(n.x + n.y + n.z, 1);
        }
}

TEST(Quads, TextureRunsAsTheTableSays) {
    for (const double at : {-2., -0., 0., 2.}) {
        const bool negative = at < 0;
        const double size = 3;
        const Mesh xy = quadXY(at, size, 2, 3), xz = quadXZ(at, size, 2, 3), yz = quadYZ(at, size, 2, 3);
        for (std::uint32_t i = 0; i < xy.vertexCount(); ++i) {
            const glm::dvec3 p = positionAt(xy, i), st = texCoordAt(xy, i);
            expectNear(p, {(negative ? -1 : 1) * size * (2 * st.x - 1), size * (2 * st.y - 1), at});
            EXPECT_EQ(tangentAt(xy, i), glm::dvec3(0, 1, 0));
        }
        for (std::uint32_t i = 0; i < xz.vertexCount(); ++i) {
            const glm::dvec3 p = positionAt(xz, i), st = texCoordAt(xz, i);
            expectNear(p, {size * (2 * st.x - 1), at, (negative ? 1 : -1) * size * (2 * st.y - 1)});
            EXPECT_EQ(tangentAt(xz, i), glm::dvec3(0, 0, negative ? 1 : -1));
        }
        for (std::uint32_t i = 0; i < yz.vertexCount(); ++i) {
            const glm::dvec3 p = positionAt(yz, i), st = texCoordAt(yz, i);
            expectNear(p, {at, size * (2 * st.y - 1), (negative ? 1 : -1) * size * (2 * st.x - 1)});
            EXPECT_EQ(tangentAt(yz, i), glm::dvec3(0, 1, 0));
        }
    }
}

TEST(Quads, AtNegativeCoordinatesKeepPositionsAndTriangles) {
    const auto same = [](const Mesh& a, const Mesh& b, int axis) {
        EXPECT_EQ(a.indices, b.indices);
        for (std::uint32_t i = 0; i < a.vertexCount(); ++i) {
            glm::dvec3 p = positionAt(a, i);
            p[axis] = -p[axis];
            EXPECT_EQ(p, positionAt(b, i));
            EXPECT_EQ(normalAt(a, i), normalAt(b, i));
        }
    };
    same(quadXY(2, 1, 3, 2), quadXY(-2, 1, 3, 2), 2);
    same(quadXZ(2, 1, 3, 2), quadXZ(-2, 1, 3, 2), 1);
    same(quadYZ(2, 1, 3, 2), quadYZ(-2, 1, 3, 2), 0);
}

TEST(Quads, CountCellsAlongTheNamedAxes) {
    const auto distinct = [](const Mesh& mesh, int axis) {
        std::vector<double> values;
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) values.push_back(positionAt(mesh, i)[axis]);
        std::sort(values.begin(), values.end());
        return std::unique(values.begin(), values.end()) - values.begin();
    };
    EXPECT_EQ(distinct(quadXY(0, 1, 2, 5), 0), 3);
    EXPECT_EQ(distinct(quadXY(0, 1, 2, 5), 1), 6);
    EXPECT_EQ(distinct(quadXZ(0, 1, 2, 5), 0), 3);
    EXPECT_EQ(distinct(quadXZ(0, 1, 2, 5), 2), 6);
    EXPECT_EQ(distinct(quadYZ(0, 1, 2, 5), 1), 3);
    EXPECT_EQ(distinct(quadYZ(0, 1, 2, 5), 2), 6);
}

TEST(Quads, BoxOfQuadsRisesFromMinusOneToOne) {
    const Mesh mesh = quadBox(5);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        EXPECT_EQ(positionAt(mesh, i).z, static_cast<int>(i / 4) * .5 - 1);
        expectNear(texCoordAt(mesh, i), (positionAt(mesh, i) + 1.0) / 2.0);
        EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, 0, 1));
        EXPECT_EQ(tangentAt(mesh, i), glm::dvec3(0, 1, 0));
    }
    EXPECT_EQ(positionAt(quadBox(1), 0).z, 0);
    EXPECT_EQ(wronglyWound(mesh), 0U);
    expectSound(mesh);
}

TEST(Clouds, PointsRunXFastestThenYThenZ) {
    const Mesh mesh = pointCloud(3, 2, 1);
    EXPECT_EQ(mesh.topology, Topology::points);
    EXPECT_EQ(countsOf(mesh), (Counts{6, 6}));
    EXPECT_EQ(positionAt(mesh, 0), glm::dvec3(-1, -1, 0));
    EXPECT_EQ(positionAt(mesh, 1), glm::dvec3(0, -1, 0));
    EXPECT_EQ(positionAt(mesh, 5), glm::dvec3(1, 1, 0));
    EXPECT_EQ(texCoordAt(mesh, 5), glm::dvec3(1, 1, .5));
    EXPECT_EQ(normalAt(mesh, 5), glm::dvec3(0, 0, 1));
    expectSound(mesh);
}

TEST(Clouds, MixIsTheStatedHash) {
    // The values of the five steps, computed by a program in another language.
    EXPECT_EQ(mix(0), 0U);
    EXPECT_EQ(mix(1), 0x688990c0U);
    EXPECT_EQ(mix(0x9e3779b9U), 0x01fce552U);
    EXPECT_EQ(mix(0xffffffffU), 0x6768824aU);
}

TEST(Clouds, JitterIsTheStatedDisplacement) {
    // Positions of jitterCloud(4, 3, 2, 7), from the same other program.
    const std::array<glm::dvec3, 3> expected{{{-0.879133781, -0.748064816, -0.322687864},
                                              {0.509131233, 0.801972330, -0.877095819},
                                              {0.847396890, 0.640572309, 0.065627337}}};
    const std::array<std::uint32_t, 3> points{0, 10, 23};
    const Mesh mesh = jitterCloud(4, 3, 2, 7);
    for (std::size_t i = 0; i < 3; ++i) expectNear(positionAt(mesh, points[i]), expected[i]);
}

TEST(Clouds, JitterStaysWithinHalfACellAndWithinTheCube) {
    for (const std::uint32_t seed : {0U, 1U, 77U, 0xffffffffU}) {
        const Mesh plain = pointCloud(9, 5, 3), mesh = jitterCloud(9, 5, 3, seed);
        const glm::dvec3 half{.125, .25, .5};
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
            const glm::dvec3 moved = glm::abs(positionAt(mesh, i) - positionAt(plain, i));
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(moved[axis], half[axis] + 1e-6);
                EXPECT_LE(std::abs(positionAt(mesh, i)[axis]), 1);
            }
            expectNear(texCoordAt(mesh, i), (positionAt(mesh, i) + 1.0) / 2.0);
        }
    }
}

TEST(Clouds, JitterIsReflectedAtTheBorder) {
    // With reflection the distances from the border are evenly distributed over half a cell; with clamping
    // half of them would be 0.
    const Mesh plain = pointCloud(30, 30, 30), mesh = jitterCloud(30, 30, 30, 5);
    for (const double side : {-1., 1.}) {
        double sum = 0;
        int count = 0;
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
            if (positionAt(plain, i).y == side) {
                sum += (1 - std::abs(positionAt(mesh, i).y)) * 29;
                ++count;
            }
        EXPECT_EQ(count, 900);
        EXPECT_NEAR(sum / count, .5, .05);  // five standard errors
    }
}

TEST(Clouds, JitterIsEvenlyDistributed) {
    const Mesh plain = pointCloud(40, 40, 40), mesh = jitterCloud(40, 40, 40, 3);
    glm::dvec3 sum(0), squares(0);
    int inner = 0;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(plain, i);
        if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > .99) continue;
        const glm::dvec3 moved = (positionAt(mesh, i) - p) * (39. / 2);
        sum += moved;
        squares += moved * moved;
        ++inner;
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(sum[axis] / inner, 0, .006);  // five standard errors
        EXPECT_NEAR(squares[axis] / inner, 1. / 12, .002);
    }
}

TEST(Clouds, SeedsAndAxesAreUnrelated) {
    const Mesh a = jitterCloud(10, 10, 10, 0), b = jitterCloud(10, 10, 10, 1);
    EXPECT_NE(a.attributes[0].values, b.attributes[0].values);
    EXPECT_EQ(a.attributes[0].values, jitterCloud(10, 10, 10, 0).attributes[0].values);
}

}  // namespace
}  // namespace glibra::geometry
