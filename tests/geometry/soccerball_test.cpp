// The soccer ball compared with the numbering and placement of language, 4.2.

#include "geometry/shapes/polyhedra.h"

#include <numbers>
#include <set>

#include "geometry/frame.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

int faceOf(const Mesh& mesh, std::uint32_t vertex) {
    return static_cast<int>(mesh.attribute(kFaceIndex)->values[vertex]);
}

/// Returns the centres of the faces, where p is 0.
std::vector<glm::dvec3> centres(const Mesh& mesh) {
    std::vector<glm::dvec3> all(32, glm::dvec3(0));
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
        if (texCoordAt(mesh, i).z == 0) all[static_cast<std::size_t>(faceOf(mesh, i))] = positionAt(mesh, i);
    return all;
}

/// Returns for each face the faces that share an edge with it.
std::vector<std::set<int>> neighbours(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> faceLeftOf;
    const auto forEachEdge = [&](auto use) {
        forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            use(a, b);
            use(b, c);
            use(c, a);
        });
    };
    forEachEdge([&](auto a, auto b) { faceLeftOf[{welded[a], welded[b]}] = faceOf(mesh, a); });
    std::vector<std::set<int>> all(32);
    forEachEdge([&](auto a, auto b) {
        const int other = faceLeftOf.at({welded[b], welded[a]});
        if (other != faceOf(mesh, a)) all[static_cast<std::size_t>(faceOf(mesh, a))].insert(other);
    });
    return all;
}

TEST(Soccerball, HasTheStatedCounts) {
    EXPECT_EQ(countsOf(soccerball(1)), (Counts{8100, 11520}));
    EXPECT_EQ(soccerballCounts(), (Counts{8100, 11520}));
}

TEST(Soccerball, IsSoundClosedAndWoundFromOutside) {
    for (const double radius : {1., .37, 100.}) {
        const Mesh mesh = soccerball(radius);
        expectSound(mesh);
        EXPECT_EQ(openEdges(mesh), 0U);
        EXPECT_EQ(wronglyWound(mesh), 0U);
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
            EXPECT_NEAR(glm::length(positionAt(mesh, i)), radius, 2e-7 * radius);
    }
    expectSound(soccerball(0));
}

TEST(Soccerball, HasTwelvePentagonsAndTwentyHexagons) {
    const Mesh mesh = soccerball(1);
    std::vector<int> triangles(32);
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        EXPECT_EQ(faceOf(mesh, a), faceOf(mesh, b));
        EXPECT_EQ(faceOf(mesh, a), faceOf(mesh, c));
        ++triangles[static_cast<std::size_t>(faceOf(mesh, a))];
    });
    for (std::size_t face = 0; face < 32; ++face) EXPECT_EQ(triangles[face], face < 12 ? 320 : 384);
}

TEST(Soccerball, PentagonsAreAtTheStatedPlaces) {
    const std::vector<glm::dvec3> centre = centres(soccerball(1));
    EXPECT_EQ(centre[0], glm::dvec3(0, 1, 0));
    EXPECT_EQ(centre[11], glm::dvec3(0, -1, 0));
    const double latitude = std::atan(.5);
    const auto place = [](double s, double f) {
        const double a = 2 * std::numbers::pi * s;
        return glm::dvec3{-std::cos(a) * std::cos(f), std::sin(f), std::sin(a) * std::cos(f)};
    };
    for (std::size_t k = 0; k < 5; ++k) {
        expectNear(centre[1 + k], place(.25 + static_cast<double>(k) / 5, latitude));
        expectNear(centre[6 + k], place(.25 + (static_cast<double>(k) + .5) / 5, -latitude));
    }
}

TEST(Soccerball, FacesTouchAsStated) {
    const std::vector<std::set<int>> touching = neighbours(soccerball(1));
    const auto pentagons = [&](int face) {
        std::set<int> found;
        for (const int each : touching[static_cast<std::size_t>(face)])
            if (each < 12) found.insert(each);
        return found;
    };
    for (int face = 0; face < 12; ++face) {
        EXPECT_EQ(touching[static_cast<std::size_t>(face)].size(), 5U);
        EXPECT_TRUE(pentagons(face).empty());
    }
    for (int k = 0; k < 5; ++k) {
        const int next = (k + 1) % 5, before = (k + 4) % 5;
        EXPECT_EQ(touching[static_cast<std::size_t>(12 + k)].size(), 6U);
        EXPECT_EQ(pentagons(12 + k), (std::set{0, 1 + k, 1 + next}));
        EXPECT_EQ(pentagons(17 + k), (std::set{1 + k, 1 + next, 6 + k}));
        EXPECT_EQ(pentagons(22 + k), (std::set{1 + k, 6 + before, 6 + k}));
        EXPECT_EQ(pentagons(27 + k), (std::set{11, 6 + before, 6 + k}));
    }
}

TEST(Soccerball, EachRowOfFacesIsCountedByRisingS) {
    const std::vector<glm::dvec3> centre = centres(soccerball(1));
    const auto s = [](const glm::dvec3& p) {
        const double turn = std::atan2(p.z, -p.x) / (2 * std::numbers::pi);
        return turn < .249 ? turn + 1 : turn;  // from .25 on
    };
    for (const std::size_t row : {1U, 6U, 12U, 17U, 22U, 27U})
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(s(centre[row + k + 1]) - s(centre[row + k]), .2, 1e-6);
}

TEST(Soccerball, PRisesFromTheCentreToTheSeam) {
    const Mesh mesh = soccerball(1);
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    std::map<std::uint32_t, std::set<int>> facesAt;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) facesAt[welded[i]].insert(faceOf(mesh, i));
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
        EXPECT_EQ(facesAt[welded[i]].size() > 1, texCoordAt(mesh, i).z == 1);
}

TEST(Soccerball, CornersLieOnTheInscribedCircleAndPicturesStandUpright) {
    const Mesh mesh = soccerball(1);
    const std::vector<glm::dvec3> centre = centres(mesh);
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    std::map<std::uint32_t, std::set<int>> facesAt;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) facesAt[welded[i]].insert(faceOf(mesh, i));
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec2 st = glm::dvec2(texCoordAt(mesh, i)) - .5;
        if (facesAt[welded[i]].size() == 3) {
            EXPECT_NEAR(glm::length(st), .5, 1e-6);
        }
        // Seen along the centre's normal, the direction of (s, t) is that of the place.
        const glm::dvec3 n = centre[static_cast<std::size_t>(faceOf(mesh, i))];
        const glm::dvec3 t = fallbackTangent(n), right = glm::cross(t, n);
        const glm::dvec3 p = positionAt(mesh, i);
        const glm::dvec2 seen{glm::dot(p, right), glm::dot(p, t)};
        if (glm::length(st) > .01) {
            EXPECT_GT(glm::dot(glm::normalize(seen), glm::normalize(st)), 1 - 1e-6);
        }
    }
}

TEST(Soccerball, TextureCoordinatesAreLinearOnTheFlatFaces) {
    // A point moves along its ray, so the flat point is p / (p . n), scaled to the plane of the face.
    const Mesh mesh = soccerball(2);
    const std::vector<glm::dvec3> centre = centres(mesh);
    std::vector<double> scale(32, 0);
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const auto face = static_cast<std::size_t>(faceOf(mesh, i));
        const glm::dvec3 n = glm::normalize(centre[face]), p = positionAt(mesh, i);
        const double flat = glm::length(p / glm::dot(p, n) - n);
        const double radius = glm::length(glm::dvec2(texCoordAt(mesh, i)) - .5);
        if (radius < .1) continue;
        if (scale[face] == 0) scale[face] = flat / radius;
        EXPECT_NEAR(flat / radius, scale[face], 1e-5);
    }
}

TEST(Soccerball, TangentsPointNorth) {
    const Mesh mesh = soccerball(1);
    int poles = 0;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 n = normalAt(mesh, i), tangent = tangentAt(mesh, i);
        if (std::abs(n.y) < 1) {
            expectNear(tangent, fallbackTangent(n), 1e-5);
            continue;
        }
        ++poles;
        // The limit along the bisector of the fan triangle, whose corners are the two ends of the last row.
        const glm::dvec3 middle = positionAt(mesh, i + 36) + positionAt(mesh, i + 44);
        expectNear(tangent, -n.y * glm::normalize(glm::dvec3{middle.x, 0, middle.z}));
    }
    EXPECT_EQ(poles, 10);
}

}  // namespace
}  // namespace glibra::geometry
