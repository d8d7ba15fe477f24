// The pyramid against its closed forms.

#include "geometry/shapes/polyhedra.h"

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

double area(const Mesh& mesh) {
    double sum = 0;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = positionAt(mesh, a);
        sum += glm::length(glm::cross(positionAt(mesh, b) - p, positionAt(mesh, c) - p)) / 2;
    });
    return sum;
}

TEST(Pyramid, HasTheClosedFormsOfAreaAndVolume) {
    for (const double base : {.1, 1 / 3., 2.})
        for (const double height : {.3, 1., 7.}) {
            const Mesh mesh = pyramid(base, height);
            EXPECT_EQ(countsOf(mesh), stated(16, 6));
            EXPECT_EQ(openEdges(mesh), 0U);
            EXPECT_EQ(wronglyWound(mesh), 0U);
            expectSound(mesh);
            EXPECT_NEAR(volume(mesh), base * base * height / 3, 1e-6 * (1 + base * base * height));
            EXPECT_NEAR(area(mesh), base * base + 2 * base * std::hypot(base / 2, height), 1e-5);
        }
}

TEST(Pyramid, EachSideHasItsTextureUpright) {
    const Mesh mesh = pyramid(2, 3);
    const FrameAgreement agreement = frameAgreement(mesh);
    EXPECT_GT(agreement.t, .999999);
    EXPECT_GT(agreement.s, .999999);
    // The side toward +z: s along +x from the left corner, the apex above its middle.
    const std::uint32_t first = 6;
    expectNear(positionAt(mesh, first), {-1, 0, 1});
    expectNear(positionAt(mesh, first + 1), {1, 0, 1});
    expectNear(positionAt(mesh, first + 2), {0, 3, 0});
    expectNear(texCoordAt(mesh, first + 2), {.5, 1, 0});
    expectNear(normalAt(mesh, first), glm::normalize(glm::dvec3(0, 1, 3)));
}

TEST(Pyramid, WithoutExtentHoldsNoNaN) {
    for (const Mesh& mesh : {pyramid(0, 1), pyramid(1, 0), pyramid(0, 0)}) expectSound(mesh);
}

}  // namespace
}  // namespace glibra::geometry
