// The plane and its repeated texture.

#include "geometry/shapes/flat.h"

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

TEST(Plane, IsASquareThatLooksUp) {
    const Mesh mesh = plane(3, 1, 1, 5, 2);
    EXPECT_EQ(countsOf(mesh), stated(6 * 3, 20));
    EXPECT_EQ(wronglyWound(mesh), 0U);
    expectSound(mesh);
    double area = 0;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = positionAt(mesh, a);
        area += glm::length(glm::cross(positionAt(mesh, b) - p, positionAt(mesh, c) - p)) / 2;
    });
    EXPECT_NEAR(area, 36, 1e-5);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        EXPECT_EQ(positionAt(mesh, i).y, 0);
        expectNear(normalAt(mesh, i), {0, 1, 0});
    }
}

TEST(Plane, RepeatsItsTextureAlongXAndAlongMinusZ) {
    const Mesh mesh = plane(2, 8, 3.5, 4, 4);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        expectNear(texCoordAt(mesh, i), {8 * (p.x + 2) / 4, 3.5 * (2 - p.z) / 4, 0});
    }
    expectSound(mesh, false);
    const FrameAgreement agreement = frameAgreement(mesh);
    EXPECT_GT(agreement.t, .999999);
    EXPECT_GT(agreement.s, .999999);
}

TEST(Plane, NegativeRepeatsMirrorTheTexture) {
    const Mesh mesh = plane(1, 1, -2, 1, 1);
    expectNear(texCoordAt(mesh, nearestVertex(mesh, {1, 0, -1})), {1, -2, 0});
    expectNear(tangentAt(mesh, 0), {0, 0, 1});
    EXPECT_GT(frameAgreement(mesh).t, .999999);
}

}  // namespace
}  // namespace glibra::geometry
