// The tetrahedron against its closed forms.

#include "geometry/shapes/polyhedra.h"

#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

TEST(Tetrahedron, IsRegularAndClosed) {
    for (const double radius : {1e-3, 1 / 3., 1., 1234.5678}) {
        const Mesh mesh = tetrahedron(radius);
        EXPECT_EQ(countsOf(mesh), stated(12, 4));
        EXPECT_EQ(openEdges(mesh), 0U);
        EXPECT_EQ(wronglyWound(mesh), 0U);
        expectSound(mesh);
        const double edge = radius * std::sqrt(8 / 3.);
        forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
                EXPECT_NEAR(glm::distance(positionAt(mesh, from), positionAt(mesh, to)), edge, 1e-6 * edge);
                EXPECT_NEAR(glm::length(positionAt(mesh, from)), radius, 1e-6 * radius);
            }
        });
        EXPECT_NEAR(volume(mesh), 8 * std::sqrt(3.) / 27 * radius * radius * radius,
                    1e-6 * radius * radius * radius);
    }
}

TEST(Tetrahedron, StandsOnAFaceAndLooksTowardTheViewer) {
    const Mesh mesh = tetrahedron(3);
    expectNear(positionAt(mesh, nearestVertex(mesh, {0, 3, 0})), {0, 3, 0});
    expectNear(positionAt(mesh, nearestVertex(mesh, {0, -1, -2})), {0, -1, -2 * std::sqrt(2.)});
    // The face opposite to the corner toward -z.
    expectNear(normalAt(mesh, 3), {0, 1 / 3., std::sqrt(8.) / 3});
    expectNear(normalAt(mesh, 9), {0, -1, 0});
    const FrameAgreement agreement = frameAgreement(mesh);
    EXPECT_GT(agreement.t, .999999);
    EXPECT_GT(agreement.s, .999999);
}

}  // namespace
}  // namespace glibra::geometry
