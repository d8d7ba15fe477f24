// Primitives: known orders of convergence, and references compared with each other.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/core/figure.h"
#include "bench/reference/surfaces.h"
#include "bench/subjects/subjects.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "geometry/shapes/teapot.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Primitives = FiguresOf<measurePrimitives>;

TEST_F(Primitives, AreSound) {
    expectSound(figures);
    EXPECT_EQ(figures.size(), 13U);
}

TEST_F(Primitives, PositionsConvergeWithTheSquareOfTheSlices) {
    for (const char* name : {"position", "outline", "volume"})
        for (const Curve& curve : figure(name).curves)
            EXPECT_NEAR(fittedOrder(curve, 16), -2, .1) << name << ", " << curve.name;
    EXPECT_NEAR(fittedOrder(curve("drawn", "sphere"), 8), -2, .1);
    EXPECT_NEAR(fittedOrder(curve("teapot-position", "grid on every patch")), -2, .2);
}

TEST_F(Primitives, CylinderIsOffByTheSagittaOfItsSlices) {
    for (const Point& point : curve("position", "cylinder").points)
        EXPECT_NEAR(point.error, 1 - std::cos(std::numbers::pi / point.setting), 1e-6) << point.label;
    for (const Point& point : curve("volume", "cylinder").points) {
        const double angle = 2 * std::numbers::pi / point.setting;
        EXPECT_NEAR(point.error, 1 - std::sin(angle) / angle, 1e-6) << point.label;
    }
}

TEST_F(Primitives, NormalsOfASphereAreTheRadiusAndThoseOfFlatTrianglesAreNot) {
    const Figure& normal = figure("normal");
    for (const Point& point : curveOf(normal, "sphere").points) EXPECT_LT(point.error, 1e-4);
    EXPECT_NEAR(fittedOrder(curveOf(normal, "sphere, flat triangles")), -1, .1);
    EXPECT_NEAR(fittedOrder(curveOf(normal, "cone")), -1, .05) << "at the apex a slice has one normal";
}

TEST_F(Primitives, TooFewStacksStopTheSphere) {
    const Curve& stopped = curve("balance", "8 stacks");
    EXPECT_GT(fittedOrder(stopped, 32), -.3);
    // The sagitta of half a stack of 22.5 degrees, for any number of slices.
    EXPECT_NEAR(stopped.points.back().error, 1 - std::cos(std::numbers::pi / 16), 2e-3);
}

TEST_F(Primitives, ShippedTeapotIsWhatAGridOfSixteenCellsWouldBe) {
    const Curve& grid = curve("teapot-position", "grid on every patch");
    const double eight = grid.points.back().error;
    ASSERT_EQ(grid.points.back().setting, 8);
    EXPECT_NEAR(curve("teapot-position", "the teapot of scenes").points[0].error, eight / 4, .1 * eight / 4);
}

TEST_F(Primitives, SoccerBallAndTeapotImproveWithTheSquareOfTheirCells) {
    for (const auto& [in, tolerance] :
         {std::pair("ball-position", .1), {"cut-volume", .1}, {"cut-outline", .5}})
        for (const Curve& curve : figure(in).curves)
            EXPECT_NEAR(fittedOrder(curve, 2), -2, tolerance) << in << ", " << curve.name;
    for (const Point& point : curve("ball-normal", "soccer ball").points) EXPECT_LT(point.error, 1e-4);
}

TEST(MeshError, SeesADisplacedVertex) {
    geometry::Mesh mesh = geometry::sphere(kSolidRadius, 64, 32);
    const double before = sphereError(mesh).distance;
    for (geometry::Attribute& each : mesh.attributes)
        if (each.name == geometry::kPosition)
            for (std::size_t i = 3000; i < 3003; ++i) each.values[i] *= 1.1F;
    EXPECT_LT(before, .01);
    EXPECT_NEAR(sphereError(mesh).distance, .1, 1e-6);
}

TEST(SignedVolume, IsThatOfABox) {
    const geometry::Mesh box = geometry::box(2, 3, 4);
    EXPECT_NEAR(signedVolume(box) * std::pow(kSolidRadius, 3), 24, 1e-12);
    EXPECT_EQ(meshBytes(box), 4. * (24 * (3 + 3 + 2 + 3) + 36));
}

TEST(BezierSurface, AgreesWithTheTeapotsVertices) {
    const geometry::Mesh mesh = geometry::teapot();
    const auto patches = geometry::teapotPatches();
    const geometry::Attribute &position = *mesh.attribute(geometry::kPosition),
                              &texCoord = *mesh.attribute(geometry::kTexCoord);
    for (std::size_t i = 0; i < mesh.vertexCount(); i += 7) {
        const glm::dvec2 st(texCoord.values[2 * i], texCoord.values[2 * i + 1]);
        const glm::dvec3 p = patchPoint(patches[i / 289], st).position;
        EXPECT_NEAR(position.values[3 * i], .5 * p.x, 1e-6);
        EXPECT_NEAR(position.values[3 * i + 1], .5 * (p.z - 1.5), 1e-6);
        EXPECT_NEAR(position.values[3 * i + 2], -.5 * p.y, 1e-6);
    }
}

TEST(BezierSurface, FindsThePointBelowAPointAboveIt) {
    const geometry::Patch patch = geometry::teapotPatches()[geometry::kTeapotBody];
    for (const glm::dvec2 st : {glm::dvec2(.3, .4), glm::dvec2(.8, .15)}) {
        const PatchPoint at = patchPoint(patch, st);
        const glm::dvec3 normal = glm::normalize(glm::cross(at.alongS, at.alongT));
        const glm::dvec2 found =
            nearestOnPatch(patch, at.position + .01 * normal, st + glm::dvec2(.02, -.03));
        EXPECT_NEAR(glm::distance(found, st), 0, 1e-6);
        // The derivatives from differences.
        const double h = 1e-6;
        const glm::dvec3 moved = patchPoint(patch, st + glm::dvec2(h, 0)).position;
        EXPECT_NEAR(glm::distance((moved - at.position) / h, at.alongS), 0, 1e-4);
        const glm::dvec3 raised = patchPoint(patch, st + glm::dvec2(0, h)).position;
        EXPECT_NEAR(glm::distance((raised - at.position) / h, at.alongT), 0, 1e-4);
    }
}

}  // namespace
}  // namespace glibra::bench::test
