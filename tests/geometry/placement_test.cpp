// Orientation, texture coordinates, normals and order, as in the tables of language, 4.

#include <algorithm>
#include <numbers>

#include "geometry/frame.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/flat.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

/// Returns the vertex with these texture coordinates.
std::uint32_t vertexAt(const Mesh& mesh, double s, double t, std::uint32_t from = 0) {
    for (std::uint32_t i = from; i < mesh.vertexCount(); ++i)
        if (glm::length(texCoordAt(mesh, i) - glm::dvec3{s, t, 0}) < 1e-6) return i;
    ADD_FAILURE() << "no vertex at " << s << ' ' << t;
    return 0;
}

TEST(Frame, UnitTurnIsExactAtQuartersAndMirroredBitForBit) {
    EXPECT_EQ(unitTurn(1, 4), glm::dvec2(0, 1));
    EXPECT_EQ(unitTurn(2, 4), glm::dvec2(-1, 0));
    EXPECT_EQ(unitTurn(9, 12), glm::dvec2(0, -1));
    for (const int n : {7, 60, 1000})
        for (int i = 0; i <= n; ++i) {
            const glm::dvec2 here = unitTurn(i, n), mirrored = unitTurn(n - i, n);
            EXPECT_EQ(here.x, mirrored.x);
            EXPECT_EQ(here.y, -mirrored.y);
            EXPECT_NEAR(here.x, std::cos(2 * std::numbers::pi * i / n), 2e-15);
            EXPECT_NEAR(here.y, std::sin(2 * std::numbers::pi * i / n), 2e-15);
        }
}

TEST(Frame, FallbackTangentIsTheUpwardDirectionAcrossTheNormal) {
    EXPECT_EQ(fallbackTangent({0, 1, 0}), glm::dvec3(0, 0, -1));
    EXPECT_EQ(fallbackTangent({0, -1, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(fallbackTangent({0, 0, 1}), glm::dvec3(0, 1, 0));
    for (const glm::dvec3 n :
         {glm::dvec3{1, 2, 3}, glm::dvec3{-1e-9, 1, 0}, glm::dvec3{1e200, -1e200, 1e199}}) {
        const glm::dvec3 unit = unitOr(n, {0, 0, 0});
        const glm::dvec3 expected = unitOr(glm::dvec3(0, 1, 0) - unit.y * unit, {0, 0, 0});
        expectNear(fallbackTangent(n), expected, 1e-6);
    }
    EXPECT_EQ(fallbackTangent({0, 0, 0}), glm::dvec3(0, 1, 0));
}

TEST(Sphere, LiesWhereTheTableSays) {
    const Mesh mesh = sphere(2, 8, 4);
    for (const auto& [s, place] : {std::pair{0., glm::dvec3{-2, 0, 0}}, std::pair{.25, glm::dvec3{0, 0, 2}},
                                   std::pair{.5, glm::dvec3{2, 0, 0}}, std::pair{.75, glm::dvec3{0, 0, -2}},
                                   std::pair{1., glm::dvec3{-2, 0, 0}}}) {
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, s, .5)), place);
        EXPECT_EQ(normalAt(mesh, vertexAt(mesh, s, .5)), place / 2.0);
        EXPECT_EQ(tangentAt(mesh, vertexAt(mesh, s, .5)), glm::dvec3(0, 1, 0));
    }
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, (i + .5) / 8, 0)), glm::dvec3(0, -2, 0));
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, (i + .5) / 8, 1)), glm::dvec3(0, 2, 0));
    }
}

TEST(Sphere, AgreesWithItsFormulaInDouble) {
    const Mesh mesh = sphere(3, 17, 9);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 st = texCoordAt(mesh, i);
        const double f = std::numbers::pi * (st.y - .5), a = 2 * std::numbers::pi * st.x;
        expectNear(positionAt(mesh, i),
                   3.0 * glm::dvec3{-std::cos(a) * std::cos(f), std::sin(f), std::sin(a) * std::cos(f)},
                   2e-6);
    }
}

TEST(Sphere, SeamDiffersInTextureCoordinatesOnly) {
    const Mesh mesh = sphere(1.1, 7, 5);
    for (int j = 1; j < 5; ++j) {
        const std::uint32_t first = vertexAt(mesh, 0, j / 5.), last = vertexAt(mesh, 1, j / 5.);
        EXPECT_EQ(positionAt(mesh, first), positionAt(mesh, last));
        EXPECT_EQ(normalAt(mesh, first), normalAt(mesh, last));
        EXPECT_EQ(tangentAt(mesh, first), tangentAt(mesh, last));
    }
}

TEST(Sphere, RowsRunNorthWithSFastestAndCellsAreSplitFrom00To11) {
    const Mesh mesh = sphere(1, 5, 3);
    // South fan, then the first cell of the only band: (00, 10, 11) (00, 11, 01).
    const std::vector<std::uint32_t> begin{0, 6, 5, 1, 7, 6}, cell{5, 6, 12, 5, 12, 11};
    EXPECT_TRUE(std::equal(begin.begin(), begin.end(), mesh.indices.begin()));
    EXPECT_TRUE(std::equal(cell.begin(), cell.end(), mesh.indices.begin() + 15));
}

TEST(Cylinder, StandsOnThePlaneYZero) {
    const Mesh mesh = cylinder(2, 3, 8, 2);
    EXPECT_EQ(positionAt(mesh, vertexAt(mesh, .25, 0)), glm::dvec3(0, 0, 2));
    EXPECT_EQ(positionAt(mesh, vertexAt(mesh, .25, .5)), glm::dvec3(0, 1.5, 2));
    EXPECT_EQ(positionAt(mesh, vertexAt(mesh, .5, 1)), glm::dvec3(2, 3, 0));
    EXPECT_EQ(normalAt(mesh, vertexAt(mesh, .5, 1)), glm::dvec3(1, 0, 0));
    EXPECT_EQ(tangentAt(mesh, vertexAt(mesh, .5, 1)), glm::dvec3(0, 1, 0));
}

TEST(Cylinder, CapsAreTexturedByXAndZ) {
    const Mesh mesh = cylinder(2, 3, 8, 2);
    int top = 0, bottom = 0;
    for (std::uint32_t i = 27; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i), n = normalAt(mesh, i);
        EXPECT_EQ(std::abs(n.y), 1);
        ++(n.y > 0 ? top : bottom);
        EXPECT_EQ(p.y, n.y > 0 ? 3 : 0);
        expectNear(texCoordAt(mesh, i), {.5 + p.x / 4, .5 - n.y * p.z / 4, 0});
        EXPECT_EQ(tangentAt(mesh, i), glm::dvec3(0, 0, -n.y));
    }
    EXPECT_EQ(top, 17);
    EXPECT_EQ(bottom, 17);
}

TEST(Cone, HasSlantNormalsAndAMidSliceApex) {
    const Mesh mesh = cone(3, 4, 8, 2);
    const std::uint32_t side = vertexAt(mesh, .5, .5);
    expectNear(positionAt(mesh, side), {1.5, 2, 0});
    expectNear(normalAt(mesh, side), {.8, .6, 0});
    expectNear(tangentAt(mesh, side), {-.6, .8, 0});
    const std::uint32_t apex = vertexAt(mesh, 3.5 / 8, 1);
    EXPECT_EQ(positionAt(mesh, apex), glm::dvec3(0, 4, 0));
    const double a = 2 * std::numbers::pi * 3.5 / 8;
    expectNear(normalAt(mesh, apex), {-.8 * std::cos(a), .6, .8 * std::sin(a)});
}

TEST(Torus, TakesTheLargerRadiusForTheRing) {
    for (const Mesh& mesh : {torus(3, 1, 4, 8), torus(1, 3, 4, 8)}) {
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, 0, 0)), glm::dvec3(4, 0, 0));
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, .25, 0)), glm::dvec3(0, 4, 0));
        EXPECT_EQ(positionAt(mesh, vertexAt(mesh, 0, .25)), glm::dvec3(3, 0, 1));
        EXPECT_EQ(normalAt(mesh, vertexAt(mesh, 0, .25)), glm::dvec3(0, 0, 1));
        EXPECT_EQ(tangentAt(mesh, vertexAt(mesh, 0, .25)), glm::dvec3(-1, 0, 0));
    }
}

TEST(Box, FacesAreInOrderWithTheirTextureDirections) {
    struct Face {
        glm::dvec3 normal, s, t;
    };
    const std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
                                     {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}};
    const glm::dvec3 size{2, 4, 6};
    const Mesh mesh = box(size.x, size.y, size.z);
    for (std::uint32_t i = 0; i < 24; ++i) {
        const Face& face = faces[i / 4];
        const glm::dvec3 st = texCoordAt(mesh, i);
        EXPECT_EQ(normalAt(mesh, i), face.normal);
        EXPECT_EQ(tangentAt(mesh, i), face.t);
        EXPECT_EQ(positionAt(mesh, i),
                  size * (face.normal * .5 + face.s * (st.x - .5) + face.t * (st.y - .5)));
    }
}

TEST(Disk, IsTexturedByXAndY) {
    const Mesh mesh = diskXY(-1, 2, 8, 4);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        EXPECT_EQ(p.z, -1);
        EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, 0, 1));
        expectNear(texCoordAt(mesh, i), {.5 + p.x / 4, .5 + p.y / 4, 0});
        const double ring = glm::length(glm::dvec2(p)) / .5;
        EXPECT_NEAR(ring, std::round(ring), 1e-6);
    }
}

TEST(Arrow, FillsMinusOneToOneAlongX) {
    const Mesh mesh = xarrow(10);
    double low = 1, high = -1;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        low = std::min(low, p.x);
        high = std::max(high, p.x);
        if (i < 25 * 10 + 25 + 24) {
            EXPECT_NEAR(texCoordAt(mesh, i).y, (p.x + 1) / 2, 1e-6);
        }
    }
    EXPECT_EQ(low, -1);
    EXPECT_EQ(high, 1);
    expectNear(positionAt(mesh, vertexAt(mesh, 0, 0)), {-1, .05, 0});
    expectNear(positionAt(mesh, vertexAt(mesh, .25, 0)), {-1, 0, .05});
    expectNear(normalAt(mesh, vertexAt(mesh, .25, 0)), {0, 0, 1});
    expectNear(tangentAt(mesh, vertexAt(mesh, .25, 0)), {1, 0, 0});
}

TEST(Arrow, ShaftTakesFourFifthsOfTheSlices) {
    for (const auto& [n, shaft] : {std::pair{2, 1}, std::pair{3, 2}, std::pair{5, 4}, std::pair{7, 6},
                                   std::pair{10, 8}, std::pair{100, 80}}) {
        const Mesh mesh = xarrow(n);
        int rings = 0;
        for (std::uint32_t i = 0; i < mesh.vertexCount(); i += 25)
            if (std::abs(glm::length(glm::dvec2(positionAt(mesh, i).y, positionAt(mesh, i).z)) - .05) <
                    1e-6 &&
                normalAt(mesh, i).x == 0)
                ++rings;
            else
                break;
        EXPECT_EQ(rings, shaft + 1) << n;
    }
}

TEST(Arrow, TailAndBackRingFaceBackwards) {
    const Mesh mesh = xarrow(5);
    for (std::uint32_t i = 25 * 5 + 25 + 24; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        const double outer = p.x == -1 ? .05 : .1;
        EXPECT_EQ(normalAt(mesh, i), glm::dvec3(-1, 0, 0));
        EXPECT_EQ(tangentAt(mesh, i), glm::dvec3(0, 1, 0));
        expectNear(texCoordAt(mesh, i), {.5 + p.z / (2 * outer), .5 + p.y / (2 * outer), 0});
    }
}

}  // namespace
}  // namespace glibra::geometry
