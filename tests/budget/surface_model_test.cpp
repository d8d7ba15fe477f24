// The error models compared with real meshes: never below the measured distance, and near it.

#include "budget/error_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "geometry/shapes/teapot.h"
#include "glib/statement_table.h"
#include "surfaces.h"

namespace glibra::budget {
namespace {

using glib::CommandId;
using test::MeshPoint;

constexpr double kFloat = 4e-7;  ///< rounding of positions, of shapes that reach to 2 or so

double model(CommandId command, const std::vector<double>& numbers, Fidelity fidelity) {
    return surfaceModel(command)->deviation(numbers, fidelity);
}

/// Expects `measured` to be within the bound and above that part of it.
void expectTight(double measured, double bound, double part, const std::string& what) {
    EXPECT_LE(measured, bound * (1 + 1e-6) + kFloat) << what;
    EXPECT_GE(measured, bound * part - kFloat) << what;
}

std::string text(const std::vector<double>& numbers) {
    std::string all;
    for (const double each : numbers) all += std::to_string(each) + " ";
    return all;
}

TEST(SurfaceModel, BoundsHowFarASphereLiesInside) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> count(3, 40);
    for (int i = 0; i < 40; ++i) {
        const std::vector<double> numbers{1.5, double(count(random)), double(count(random))};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Sphere"), numbers);
        const double inside =
            test::farthest(mesh, [](const MeshPoint& p) { return std::abs(1.5 - glm::length(p.place)); });
        // With an odd number of stacks a row of quads straddles the equator: there the bound is exact. The
        // centre of a quad is not a point of the grid on its triangles, and with few slices not on the quad.
        expectTight(inside, model(glib::commandOf("Sphere"), numbers, Fidelity::shape), .75, text(numbers));
    }
}

TEST(SurfaceModel, BoundsHowFarAPatternMovesOnASphere) {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> count(6, 60);
    for (int i = 0; i < 30; ++i) {
        const std::vector<double> numbers{1.5, double(count(random)), double(count(random))};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Sphere"), numbers);
        const double moved = test::farthest(mesh, [](const MeshPoint& p) {
            return glm::length(p.place - test::spherePoint(1.5, p.texCoord.x, p.texCoord.y));
        });
        expectTight(moved, model(glib::commandOf("Sphere"), numbers, Fidelity::pattern), .55, text(numbers));
    }
}

TEST(SurfaceModel, BoundsCylindersAndCones) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> slices(3, 50), stacks(1, 12);
    for (const bool narrows : {false, true})
        for (int i = 0; i < 20; ++i) {
            const CommandId command = narrows ? glib::commandOf("Cone") : glib::commandOf("Cylinder");
            const std::vector<double> numbers{1.2, 2, double(slices(random)), double(stacks(random))};
            geometry::Mesh mesh = test::meshOf(command, numbers);
            // The side alone, which comes first: caps are flat.
            mesh.indices.resize(
                static_cast<std::size_t>(3 * numbers[2] * (narrows ? 2 * numbers[3] - 1 : 2 * numbers[3])));
            const double inside = test::farthest(mesh, [&](const MeshPoint& p) {
                const double radius = narrows ? 1.2 * (1 - p.place.y / 2) : 1.2;
                return std::abs(radius - std::hypot(p.place.x, p.place.z));
            });
            expectTight(inside, model(command, numbers, Fidelity::shape), .95, text(numbers));
            const double moved = test::farthest(mesh, [&](const MeshPoint& p) {
                return glm::length(p.place - test::conePoint(1.2, 2, p.texCoord.x, p.texCoord.y, narrows));
            });
            expectTight(moved, model(command, numbers, Fidelity::pattern), .4, text(numbers));
        }
}

TEST(SurfaceModel, BoundsTori) {
    std::mt19937 random(4);
    std::uniform_int_distribution<int> count(5, 60);
    for (int i = 0; i < (GLIBRA_SANITIZED ? 8 : 30); ++i) {
        const std::vector<double> numbers{.4, 1, double(count(random)), double(count(random))};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Torus"), numbers);
        const double inside =
            test::farthest(mesh, [](const MeshPoint& p) { return test::torusDistance(1, .4, p.place); });
        expectTight(inside, model(glib::commandOf("Torus"), numbers, Fidelity::shape), .7, text(numbers));
        const double moved = test::farthest(mesh, [](const MeshPoint& p) {
            return glm::length(p.place - test::torusPoint(1, .4, p.texCoord.x, p.texCoord.y));
        });
        expectTight(moved, model(glib::commandOf("Torus"), numbers, Fidelity::pattern), .45, text(numbers));
    }
}

TEST(SurfaceModel, BoundsTheRimOfADisk) {
    for (const double slices : {3., 7., 36., 200.}) {
        const std::vector<double> numbers{-.5, 2, slices, 3};
        // The rim is cut off most in the middle of a slice.
        const double cut = 2 - 2 * std::cos(std::numbers::pi / slices);
        EXPECT_NEAR(model(glib::commandOf("DiskXY"), numbers, Fidelity::shape), cut, 1e-12);
        const geometry::Extent extent = surfaceModel(glib::commandOf("DiskXY"))->extent(numbers);
        EXPECT_EQ(extent.low, glm::dvec3(-2, -2, -.5));
        EXPECT_EQ(extent.high, glm::dvec3(2, 2, -.5));
    }
}

TEST(SurfaceModel, BoundsArrows) {
    for (const double sides : {3., 8., 24., 60.}) {
        const std::vector<double> numbers{40, sides};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Xarrow"), numbers);
        const double inside = test::farthest(mesh, [](const MeshPoint& p) {
            const double radius = std::hypot(p.place.y, p.place.z);
            if (p.place.x >= .6 - 1e-6) return std::abs(radius - std::min(.1, .1 * (1 - p.place.x) / .4));
            return p.place.x > -1 + 1e-6 ? std::abs(radius - .05) : 0.;
        });
        // The back ring is flat and lies at x = .6, where radii from .05 to .1 are all on it.
        EXPECT_GE(model(glib::commandOf("Xarrow"), numbers, Fidelity::shape) * 1.000001 + kFloat,
                  .1 * (1 - std::cos(std::numbers::pi / sides)));
        EXPECT_GT(inside, 0);
    }
}

/// Returns the surface point that has the interpolated texture coordinates. They are linear on the flat faces
/// of a soccer ball, so the flat point is also interpolated.
glm::dvec3 ballPoint(const geometry::Mesh& mesh, const MeshPoint& p, const glm::dvec3& faceNormal) {
    glm::dvec3 flat(0);
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 place = test::valueAt(mesh, geometry::kPosition, p.corners[std::size_t(c)]);
        flat += p.weights[c] * place / glm::dot(place, faceNormal);
    }
    return glm::normalize(flat);
}

TEST(SurfaceModel, BoundsSoccerballs) {
    for (int cuts = 1; cuts <= (GLIBRA_SANITIZED ? 9 : 24); cuts += cuts < 4 ? 1 : 5) {
        const std::vector<double> numbers{1, double(cuts)};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Soccerball"), numbers);
        std::map<float, glm::dvec3> normals;  // by face: the vertex with p = 0
        const geometry::Attribute& faces = *mesh.attribute(geometry::kFaceIndex);
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
            if (test::valueAt(mesh, geometry::kTexCoord, i).z == 0)
                normals[faces.values[i]] = test::valueAt(mesh, geometry::kPosition, i);
        ASSERT_EQ(normals.size(), 32U);
        const double inside =
            test::farthest(mesh, [](const MeshPoint& p) { return 1 - glm::length(p.place); }, 7);
        expectTight(inside, model(glib::commandOf("Soccerball"), numbers, Fidelity::shape),
                    cuts < 3 ? .5 : .8, text(numbers));
        const double moved = test::farthest(
            mesh,
            [&](const MeshPoint& p) {
                return glm::length(p.place - ballPoint(mesh, p, normals[faces.values[p.corners[0]]]));
            },
            7);
        expectTight(moved, model(glib::commandOf("Soccerball"), numbers, Fidelity::pattern), .35,
                    text(numbers));
    }
}

/// De Casteljau, in our coordinates.
glm::dvec3 patchPoint(const geometry::Patch& patch, double s, double t) {
    const auto curve = [](std::array<glm::dvec3, 4> p, double u) {
        for (std::size_t n = 3; n > 0; --n)
            for (std::size_t i = 0; i < n; ++i) p[i] = p[i] * (1 - u) + p[i + 1] * u;
        return p[0];
    };
    std::array<glm::dvec3, 4> column;
    for (std::size_t i = 0; i < 4; ++i) column[i] = curve(patch[i], s);
    return geometry::teapotPlace(curve(column, t));
}

TEST(SurfaceModel, BoundsTeapots) {
    const auto patches = geometry::teapotPatches();
    for (const int cells : {2, 5, 9, 16, 30}) {
        if (GLIBRA_SANITIZED && cells > 9) break;
        const std::vector<double> numbers{double(cells)};
        const geometry::Mesh mesh = test::meshOf(glib::commandOf("Teapot"), numbers);
        const auto stride = static_cast<std::uint32_t>((cells + 1) * (cells + 1));
        const auto off = [&](const MeshPoint& p) {
            return p.place - patchPoint(patches[p.corners[0] / stride], p.texCoord.x, p.texCoord.y);
        };
        const double moved = test::farthest(mesh, [&](const MeshPoint& p) { return glm::length(off(p)); });
        expectTight(moved, model(glib::commandOf("Teapot"), numbers, Fidelity::pattern), .6, text(numbers));
        // Except for the bend of the surface, the distance from it is at most the part along its normal.
        const double inside = test::farthest(mesh, [&](const MeshPoint& p) {
            constexpr double kStep = 1e-4;
            const geometry::Patch& patch = patches[p.corners[0] / stride];
            const double s = std::clamp(p.texCoord.x, kStep, 1 - kStep);
            const double t = std::clamp(p.texCoord.y, kStep, 1 - kStep);
            const glm::dvec3 normal =
                glm::cross(patchPoint(patch, s + kStep, t) - patchPoint(patch, s - kStep, t),
                           patchPoint(patch, s, t + kStep) - patchPoint(patch, s, t - kStep));
            const double length = glm::length(normal);
            return length > 1e-14 ? std::abs(glm::dot(off(p), normal)) / length : 0.;
        });
        expectTight(inside, model(glib::commandOf("Teapot"), numbers, Fidelity::shape), .7, text(numbers));
    }
}

TEST(SurfaceModel, TeapotsOfAnyCellsMeetAlongTheirSeams) {
    for (const int cells : {2, 5, 7, 16, 23}) {
        const geometry::Mesh mesh = geometry::teapot(cells);
        EXPECT_EQ(mesh.vertexCount(), geometry::teapotCounts(cells).vertices);
        EXPECT_EQ(mesh.indices.size(), 3 * geometry::teapotCounts(cells).primitives);
        // Edges are identified by the bits of their ends; an edge that is used once is a border. The borders
        // are the rims of the pot, with one segment per cell.
        using Ends = std::array<float, 6>;
        std::map<Ends, int> edges;
        const auto& places = mesh.attribute(geometry::kPosition)->values;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                std::array<float, 3> a, b;
                for (std::size_t c = 0; c < 3; ++c) {
                    a[c] = places[3 * mesh.indices[i + k] + c];
                    b[c] = places[3 * mesh.indices[i + (k + 1) % 3] + c];
                }
                if (b < a) std::swap(a, b);
                ++edges[{a[0], a[1], a[2], b[0], b[1], b[2]}];
            }
        int borders = 0;
        for (const auto& [ends, uses] : edges) borders += uses == 1 ? 1 : 0;
        EXPECT_EQ(borders % cells, 0) << cells;
        EXPECT_EQ(borders / cells, 16) << cells;
    }
}

TEST(SurfaceModel, DoesNotRiseWithAnyCount) {
    for (const CommandId command :
         {glib::commandOf("Sphere"), glib::commandOf("Cylinder"), glib::commandOf("Cone"),
          glib::commandOf("Torus"), glib::commandOf("DiskXY"), glib::commandOf("Xarrow")})
        for (const Fidelity fidelity : {Fidelity::shape, Fidelity::pattern}) {
            const SurfaceModel& row = *surfaceModel(command);
            for (const CountArgument& count : row.usedCounts()) {
                std::vector<double> numbers =
                    command == glib::commandOf("Sphere")   ? std::vector<double>{1, 12, 12}
                    : command == glib::commandOf("Xarrow") ? std::vector<double>{12, 12}
                                                           : std::vector<double>{1, .5, 12, 12};
                double last = 1e9;
                for (int n = std::max(count.least, 2); n < 200; ++n) {
                    numbers[count.index] = n;
                    const double now = row.deviation(numbers, fidelity);
                    EXPECT_LE(now, last) << static_cast<int>(command) << " " << n;
                    last = now;
                }
            }
        }
}

TEST(SurfaceModel, HasNoRowForWhatItsCountsShow) {
    for (const CommandId command :
         {glib::commandOf("Box"), glib::commandOf("WireSphere"), glib::commandOf("QuadBox"),
          glib::commandOf("PointCloud"), CommandId::obj})
        EXPECT_EQ(surfaceModel(command), nullptr);
}

}  // namespace
}  // namespace glibra::budget
