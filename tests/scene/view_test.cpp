// Projections, and the policy that moves the eye back, compared with numbers computed by hand (language, 2.5
// and 3.1).

#include "scene/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <memory>
#include <numbers>

#include "scene/primitives.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::run;

constexpr double kDegree = std::numbers::pi / 180;

/// The result of the policy for the real meshes. `asked` counts the meshes that it requests.
ViewMove viewOf(const Scene& scene, double aspect = 1, int* asked = nullptr) {
    std::map<ShapeIndex, geometry::Mesh> meshes;
    return autoView(
        scene,
        [&](ShapeIndex shape) -> const geometry::Mesh* {
            if (asked != nullptr) ++*asked;
            const auto [entry, isNew] = meshes.try_emplace(shape);
            if (isNew)
                if (auto mesh = makeMesh(scene, shape)) entry->second = std::move(*mesh);
            return &entry->second;
        },
        aspect);
}
double distanceOf(std::string_view text, double aspect = 1) {
    return viewOf(run(text), aspect).distance;
}
double sixteenths(double distance) {
    return std::ceil(16 * distance) / 16;
}

/// The point (x / w, y / w, z / w) after projection of a point in eye space.
glm::dvec3 projected(const Projection& projection, double aspect, const glm::dvec3& p) {
    const glm::dvec4 clip = projectionMatrix(projection, aspect) * glm::dvec4(p, 1);
    return glm::dvec3(clip) / clip.w;
}
void expectProjected(const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << "component " << i;
}

TEST(Projection, PerspectiveIsThatOfGlm) {
    for (const double fov : {1., 50., 90., 179.}) {
        const glm::dmat4 made = projectionMatrix(Perspective{fov, .1, 1000}, 1.5);
        const glm::dmat4 expected = glm::perspective(fov * kDegree, 1.5, .1, 1000.);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                EXPECT_NEAR(made[i][j], expected[i][j], 1e-12 * (1 + std::abs(expected[i][j])));
    }
}

TEST(Projection, PerspectiveAngleIsTheFullVerticalOne) {
    const Perspective view{50, 2, 10};
    const double top = 2 * std::tan(25 * kDegree);
    expectProjected(projected(view, 2, {0, top, -2}), {0, 1, -1});
    expectProjected(projected(view, 2, {2 * top, 0, -2}), {1, 0, -1});
    expectProjected(projected(view, 2, {0, 0, -10}), {0, 0, 1});
}

TEST(Projection, OrthoShowsTheBoxWholeAndUndistorted) {
    const Orthographic wide{0, 4, 0, 1, -1, 1};  // wider than the viewport: height grows to 4 / 2 about .5
    expectProjected(projected(wide, 2, {0, -.5, 0}), {-1, -1, 0});
    expectProjected(projected(wide, 2, {4, 1.5, 1}), {1, 1, -1});
    const Orthographic tall{0, 1, 0, 4, -1, 1};  // width grows to 4 * 2 about .5
    expectProjected(projected(tall, 2, {-3.5, 0, 0}), {-1, -1, 0});
    expectProjected(projected(tall, 2, {4.5, 4, -1}), {1, 1, 1});
    const Orthographic fits{-3, 3, -1.5, 1.5, -1, 1};
    expectProjected(projected(fits, 2, {3, 1.5, 0}), {1, 1, 0});
}

TEST(Projection, OrthoWithExchangedLimitsMirrors) {
    expectProjected(projected(Orthographic{3, -3, -3, 3, -1, 1}, 1, {3, 3, 0}), {-1, 1, 0});
    expectProjected(projected(Orthographic{-3, 3, 3, -3, -1, 1}, 2, {6, 3, 0}), {1, -1, 0});
}

TEST(Projection, OrthoNearAndFarAreDistancesAlongMinusZ) {
    expectProjected(projected(Orthographic{-1, 1, -1, 1, 2, 6}, 1, {0, 0, -2}), {0, 0, -1});
    expectProjected(projected(Orthographic{-1, 1, -1, 1, 2, 6}, 1, {0, 0, -6}), {0, 0, 1});
}

TEST(Projection, OrthoWithEqualLimitsUsesOne) {
    expectProjected(projected(Orthographic{0, 0, 0, 0, -1, 1}, 1, {1, -1, 0}), {1, -1, 0});
    expectProjected(projected(Orthographic{5, 5, -2, 2, -1, 1}, 1, {2, 2, 0}), {1, 1, 0});
}

TEST(ViewPolicy, TheDefaultSphereIsSeenWhole) {
    // c = 0, r = 1, half angle 25 degrees: D = 1 / sin 25 = 2.3662, rounded up to sixteenths 2.375.
    const ViewMove move = viewOf(run("Sphere\n"));
    EXPECT_EQ(move.distance, 2.375);
    ASSERT_EQ(move.diagnostics.size(), 1U);
    EXPECT_EQ(toString(move.diagnostics[0]),
              "scene.glib:1:1: note: no LookAt, so the eye is moved back by 2.375 along z (use --eye glman "
              "to switch "
              "this off) "
              "[draw-N01]");
}

TEST(ViewPolicy, TheDistanceIsMeasuredInEyeSpace) {
    EXPECT_EQ(distanceOf("Rotate 90 1 0 0\nSphere\n"), 2.375);
}

TEST(ViewPolicy, ASceneWithLookAtIsLeftAlone) {
    int asked = 0;
    EXPECT_EQ(viewOf(run("LookAt 0 0 .5 0 0 0 0 1 0\nSphere\n"), 1, &asked).distance, 0);
    EXPECT_EQ(viewOf(run("Sphere\nPushMatrix\nLookAt 0 0 5 0 0 0 0 1 0\nPopMatrix\n"), 1, &asked).distance,
              0);
    EXPECT_EQ(asked, 0) << "no mesh is needed to know that";
}

TEST(ViewPolicy, OrthographicDrawsAreIgnored) {
    int asked = 0;
    EXPECT_EQ(viewOf(run("Ortho\nSphere\n"), 1, &asked).distance, 0);
    EXPECT_EQ(viewOf(run("Sphere 0\n")).distance, 0);
    EXPECT_EQ(viewOf(run("\n")).distance, 0);
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(distanceOf("Sphere\nOrtho\nSphere 100\n"), 2.375) << "the large sphere is orthographic";
}

TEST(ViewPolicy, ShapesThatTheViewDoesNotPlaceAreIgnored) {
    EXPECT_EQ(distanceOf("Sphere\nSkyBox 100\nFullScreen\n"), 2.375);
    EXPECT_EQ(distanceOf("SkyBox\n"), 0);
}

TEST(ViewPolicy, ASceneWhollyInFrontOfTheNearPlaneStays) {
    EXPECT_EQ(distanceOf("Translate 0 0 -1.2\nSphere\n"), 0);
    EXPECT_EQ(distanceOf("Translate 0 0 -1.125\nSphere\n"), 0) << "c.z + r = -.125 <= -.1";
    EXPECT_GT(distanceOf("Translate 0 0 -1.0625\nSphere\n"), 0);
    EXPECT_GT(distanceOf("Perspective 50 .25 100\nTranslate 0 0 -1.125\nSphere\n"), 0) << "near .25 cuts it";
}

TEST(ViewPolicy, OneDrawWhollyInFrontKeepsTheEyeAtTheOrigin) {
    // Quads form a room around the eye. The quad at z = -1 shows that the scene expects an eye at the origin.
    EXPECT_EQ(distanceOf("QuadXY -1\nQuadXY 1\nQuadXZ -1\nQuadXZ 1\nQuadYZ -1\nQuadYZ 1\n"), 0);
    EXPECT_GT(distanceOf("QuadXY 1\nQuadXZ -1\nQuadXZ 1\nQuadYZ -1\nQuadYZ 1\n"), 0);
}

TEST(ViewPolicy, CentreAndRadiusAreThoseOfTheBoxOfAllVertices) {
    // Two points at x = 0 and 4, z = 0: c = (2, 0, 0), r = 2, a = 30: D = (2 + 2 cos 30) / sin 30.
    const char* text = "Perspective 60\nglBegin lines\nglVertex 0 0 0\nglVertex 4 0 0\nglEnd\n";
    EXPECT_EQ(distanceOf(text), sixteenths((2 + 2 * std::cos(30 * kDegree)) / .5));
    // The same in two draws, and moved: c = (0, 2, 3), r = 2.
    EXPECT_EQ(distanceOf("Perspective 60\nTranslate 0 0 3\nglBegin points\nglVertex 0 0 0\nglEnd\n"
                         "Translate 0 4 0\nglBegin points\nglVertex 0 0 0\nglEnd\n"),
              sixteenths((2 + 2 * std::cos(30 * kDegree)) / .5 + 3));
}

TEST(ViewPolicy, TheRadiusIsTheFarthestVertexNotTheBox) {
    // An octahedron: box half diagonal sqrt 3, but no vertex farther than 1.
    EXPECT_EQ(distanceOf("Perspective 60\nglBegin points\nglVertex 1 0 0\nglVertex -1 0 0\nglVertex 0 1 0\n"
                         "glVertex 0 -1 0\nglVertex 0 0 1\nglVertex 0 0 -1\nglEnd\n"),
              2);
}

TEST(ViewPolicy, TheSmallerFieldOfViewCounts) {
    // In a tall window the horizontal half angle h is smaller: tan h = .5 tan 25.
    const double half = std::atan(.5 * std::tan(25 * kDegree));
    EXPECT_EQ(distanceOf("Sphere\n", .5), sixteenths(1 / std::sin(half)));
    EXPECT_EQ(distanceOf("Sphere\n", 2), 2.375);
    EXPECT_EQ(distanceOf("Sphere\nPerspective 20\nSphere\n"), sixteenths(1 / std::sin(10 * kDegree)));
}

TEST(ViewPolicy, TheAspectIsThatOfTheTarget) {
    const double half = std::atan(.25 * std::tan(25 * kDegree));
    EXPECT_EQ(
        distanceOf("Texture2D 6 64 256\nRenderToTexture 6\nSphere\nRenderToTexture\nOrtho\nQuadXY\n", 1),
        sixteenths(1 / std::sin(half)));
}

TEST(ViewPolicy, AFourthCoordinateAddsToTheDistance) {
    const auto text = [](const std::string& w) {
        return "Perspective 60\nglBegin points\nglVertex 0 0 0 " + w + "\nglEnd\n";
    };
    EXPECT_EQ(distanceOf(text("3")), 6);
    EXPECT_EQ(distanceOf(text("-3")), 6);
    EXPECT_EQ(distanceOf(text("1")), 0) << "a single point has no size";
    EXPECT_EQ(distanceOf(text("0")), 0);
}

TEST(ViewPolicy, ShapesThatCannotBeMadeAreIgnored) {
    EXPECT_EQ(distanceOf("Obj absent.obj\n"), 0);
    EXPECT_EQ(distanceOf("Obj absent.obj\nSphere\n"), 2.375);
    const Scene scene = run("Sphere\n");
    EXPECT_EQ(autoView(scene, [](ShapeIndex) { return nullptr; }, 1).distance, 0);
}

TEST(ViewPolicy, SingularAndHugeMatricesGiveFiniteDistances) {
    EXPECT_EQ(distanceOf("Scale 0\nSphere\n"), 0);
    EXPECT_TRUE(std::isfinite(distanceOf("Scale 1e30\nSphere\n")));
}

}  // namespace
}  // namespace glibra::scene
