// The cube of the sky, seen from inside.

#include "geometry/frame.h"
#include "geometry/shapes/polyhedra.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

TEST(SkyBox, IsAClosedCubeThatLooksInward) {
    for (const double side : {.1, 1 / 3., 2., 50.}) {
        const Mesh mesh = skyBox(side);
        EXPECT_EQ(countsOf(mesh), stated(24, 12));
        EXPECT_EQ(openEdges(mesh), 0U);
        EXPECT_EQ(wronglyWound(mesh), 0U);
        EXPECT_NEAR(volume(mesh), -side * side * side, 1e-6 * side * side * side) << "inside out";
        for (std::uint32_t i = 0; i < 24; ++i)
            EXPECT_LT(glm::dot(normalAt(mesh, i), positionAt(mesh, i)), 0) << "toward the centre";
    }
}

TEST(SkyBox, TextureCoordinatesAreTheDirection) {
    const Mesh mesh = skyBox(10);
    EXPECT_EQ(mesh.attribute(kTexCoord)->components, 3);
    for (std::uint32_t i = 0; i < 24; ++i) {
        EXPECT_EQ(5. * texCoordAt(mesh, i), positionAt(mesh, i));
        EXPECT_EQ(tangentAt(mesh, i), fallbackTangent(normalAt(mesh, i)));
    }
}

TEST(SkyBox, FacesComeInTheOrderOfABox) {
    const Mesh sky = skyBox(2), solid = box(2, 2, 2);
    for (std::uint32_t i = 0; i < 24; i += 4) EXPECT_EQ(normalAt(sky, i), -normalAt(solid, i));
}

}  // namespace
}  // namespace glibra::geometry
