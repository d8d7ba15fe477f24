// Neighbours of triangles, against brute force and against what closed surfaces must satisfy.

#include "geometry/adjacency.h"

#include <map>
#include <set>
#include <string>

#include "geometry/list_mesh.h"
#include "geometry/mix.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/flat.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/primitive.h"
#include "geometry/shapes/spheres.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

Indices triangles(const Mesh& mesh) {
    return adjacencyIndices(mesh, Topology::trianglesAdjacency);
}
Indices edges(const Mesh& mesh) {
    return adjacencyIndices(mesh, Topology::linesAdjacency);
}

/// Triangles between the positions of these numbers; each corner is a vertex of its own.
Mesh loose(const std::vector<glm::dvec3>& places, const Indices& corners) {
    Mesh mesh;
    mesh.attributes.push_back({std::string(kPosition), 3, {}});
    for (const std::uint32_t corner : corners) {
        for (int axis = 0; axis < 3; ++axis)
            mesh.attributes[0].values.push_back(static_cast<float>(places[corner][axis]));
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
    }
    return mesh;
}

/// The place of the far corner across a side, found by trying all other triangles.
glm::dvec3 bruteForce(const Mesh& mesh, std::size_t triangle, std::size_t side) {
    const auto place = [&](std::size_t t, std::size_t c) {
        return positionAt(mesh, mesh.indices[3 * t + c % 3]);
    };
    const glm::dvec3 a = place(triangle, side), b = place(triangle, side + 1);
    if (a != b)
        for (const bool isOpposite : {true, false})
            for (std::size_t other = 0; other < mesh.indices.size() / 3; ++other)
                for (std::size_t c = 0; c < 3; ++c)
                    if (other != triangle && place(other, c) == (isOpposite ? b : a) &&
                        place(other, c + 1) == (isOpposite ? a : b))
                        return place(other, c + 2);
    return place(triangle, side + 2);
}

void expectAsBruteForce(const Mesh& mesh, const std::string& name) {
    const Indices found = triangles(mesh);
    ASSERT_EQ(found.size(), 2 * mesh.indices.size()) << name;
    for (std::size_t side = 0; side < mesh.indices.size(); ++side) {
        EXPECT_EQ(found[2 * side], mesh.indices[side]) << name;
        EXPECT_EQ(positionAt(mesh, found[2 * side + 1]), bruteForce(mesh, side / 3, side % 3))
            << name << ' ' << side;
    }
}

TEST(Adjacency, IsThatOfBruteForceOnSolids) {
    expectAsBruteForce(tetrahedron(1), "tetrahedron");
    expectAsBruteForce(box(1, 2, 3), "box");
    expectAsBruteForce(sphere(1, 9, 6), "sphere");
    expectAsBruteForce(torus(.4, 1, 6, 9), "torus");
    expectAsBruteForce(plane(1, 2, 3, 4, 5), "plane");
}

TEST(Adjacency, IsThatOfBruteForceOnTangledTriangles) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        // Triangles among a few places: borders, edges of many triangles in both directions, some without
        // area.
        const std::uint32_t count = 4 + 2 * seed;
        const auto random = [&](std::uint32_t i) { return mix(mix(i) + seed * 7919); };
        std::vector<glm::dvec3> places;
        for (std::uint32_t i = 0; i < count; ++i)
            places.emplace_back(random(i) % 3, random(i + 1000) % 3, random(i + 2000) % 2);
        Indices corners;
        for (std::uint32_t i = 0; i < 180; ++i) corners.push_back(random(5000 + i) % count);
        // A triangle that passes an edge twice has two far corners for its neighbours; none is left in.
        const auto twice = [&](std::size_t i) {
            return places[corners[i]] == places[corners[i + 1]] ||
                   places[corners[i]] == places[corners[i + 2]] ||
                   places[corners[i + 1]] == places[corners[i + 2]];
        };
        Indices kept;
        for (std::size_t i = 0; i < corners.size(); i += 3)
            if (!twice(i))
                kept.insert(kept.end(), corners.begin() + static_cast<std::ptrdiff_t>(i),
                            corners.begin() + static_cast<std::ptrdiff_t>(i) + 3);
        expectAsBruteForce(loose(places, kept), "seed " + std::to_string(seed));
    }
}

TEST(Adjacency, OfATetrahedronIsTheFourthCorner) {
    const Mesh mesh = tetrahedron(1);
    const Indices found = triangles(mesh);
    for (std::size_t t = 0; t < 4; ++t) {
        std::set<PositionBits> own, far;
        const auto bits = [&](std::size_t at) {
            const glm::dvec3 p = positionAt(mesh, found[6 * t + at]);
            return PositionBits{std::bit_cast<std::uint32_t>(static_cast<float>(p.x)),
                                std::bit_cast<std::uint32_t>(static_cast<float>(p.y)),
                                std::bit_cast<std::uint32_t>(static_cast<float>(p.z))};
        };
        for (const std::size_t at : {0U, 2U, 4U}) own.insert(bits(at));
        for (const std::size_t at : {1U, 3U, 5U}) far.insert(bits(at));
        EXPECT_EQ(own.size(), 3U);
        EXPECT_EQ(far.size(), 1U);
        EXPECT_FALSE(own.contains(*far.begin()));
    }
}

/// Counts the sides whose far corner is that of the triangle itself.
std::size_t sidesWithoutNeighbour(const Mesh& mesh) {
    const Indices found = triangles(mesh);
    std::size_t count = 0;
    for (std::size_t side = 0; side < mesh.indices.size(); ++side)
        count += found[2 * side + 1] == mesh.indices[side - side % 3 + (side + 2) % 3] ? 1 : 0;
    return count;
}

TEST(Adjacency, ClosedShapesHaveANeighbourAtEverySide) {
    for (const PrimitiveSpec* each : primitives()) {
        if (!each->isClosed) continue;
        const Mesh mesh = each->make(completeNumbers(*each, {}));
        EXPECT_EQ(sidesWithoutNeighbour(mesh), 0U) << each->names[0];
    }
}

TEST(Adjacency, SidesAtTheBorderTurnTheTriangleOver) {
    EXPECT_EQ(sidesWithoutNeighbour(plane(1, 1, 1, 4, 5)), 2U * (4 + 5));
    EXPECT_EQ(triangles(loose({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2})), (Indices{0, 2, 1, 0, 2, 1}));
}

TEST(Adjacency, OfAFanOfFiveTrianglesPrefersTheOppositeDirection) {
    // Five triangles at the edge 0-1; the second and the fourth traverse it from 1 to 0.
    const std::vector<glm::dvec3> places{{0, 0, 0}, {0, 0, 1},  {1, 0, 0}, {1, 1, 0},
                                         {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}};
    const Mesh fan = loose(places, {0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5, 0, 1, 6});
    const Indices found = triangles(fan);
    const auto far = [&](std::size_t triangle) { return positionAt(fan, found[6 * triangle + 1]); };
    EXPECT_EQ(far(0), places[3]);
    EXPECT_EQ(far(1), places[2]);
    EXPECT_EQ(far(2), places[3]) << "the first one in the opposite direction";
    EXPECT_EQ(far(3), places[2]);
    EXPECT_EQ(far(4), places[3]);
    // Without any in the opposite direction it is the first other one.
    const Mesh same = loose(places, {0, 1, 2, 0, 1, 3, 0, 1, 4});
    const Indices others = triangles(same);
    EXPECT_EQ(positionAt(same, others[1]), places[3]);
    EXPECT_EQ(positionAt(same, others[7]), places[2]);
    EXPECT_EQ(positionAt(same, others[13]), places[2]);
}

TEST(Adjacency, InOrderIgnoresDirections) {
    const std::vector<glm::dvec3> places{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const Mesh fan = loose(places, {0, 1, 2, 0, 1, 3, 1, 0, 4});
    const Indices found = adjacencyIndices(fan, Topology::trianglesAdjacency, Neighbours::inOrder);
    EXPECT_EQ(positionAt(fan, found[1]), places[3]);
    EXPECT_EQ(positionAt(fan, found[7]), places[2]);
    EXPECT_EQ(positionAt(fan, found[13]), places[2]);
    EXPECT_EQ(found[3], found[2]) << "a border has the first vertex of the edge";
}

TEST(Adjacency, EqualPlacesWithDifferentWAreDifferent) {
    std::vector<ListVertex> vertices(6);
    const std::array<glm::dvec3, 6> places{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 0}}};
    for (std::size_t i = 0; i < 6; ++i) vertices[i].position = {places[i].x, places[i].y, places[i].z, 1};
    const auto meshOf = [&] { return meshFromList(ListTopology::triangles, vertices, false, 0).mesh; };
    EXPECT_EQ(triangles(meshOf())[1], 5U);
    vertices[3].position[3] = 2;
    EXPECT_EQ(triangles(meshOf())[1], 2U) << "no neighbour: its own far corner";
}

TEST(Adjacency, OutlinesOfSolidsAreClosedLoops) {
    // Seen from outside, the edges between a triangle that faces the eye and one that does not form loops:
    // each place has an even number of them.
    const glm::dvec3 eye{3, 1.7, 4.1};
    for (const Mesh& mesh : {sphere(1, 12, 8), torus(.4, 1, 9, 14), box(1, 1, 1), tetrahedron(1)}) {
        const Indices found = triangles(mesh);
        const std::vector<std::uint32_t> welded = weldedByBits(mesh);
        const auto faces = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            const glm::dvec3 p = positionAt(mesh, a);
            return glm::dot(glm::cross(positionAt(mesh, b) - p, positionAt(mesh, c) - p), eye - p) > 0;
        };
        std::map<std::uint32_t, int> uses;
        for (std::size_t t = 0; t < found.size(); t += 6) {
            if (!faces(found[t], found[t + 2], found[t + 4])) continue;
            for (std::size_t i = 0; i < 6; i += 2) {
                const std::uint32_t from = found[t + i], to = found[t + (i + 2) % 6];
                if (faces(to, from, found[t + i + 1])) continue;
                ++uses[welded[from]];
                ++uses[welded[to]];
            }
        }
        EXPECT_GE(uses.size(), 3U);
        for (const auto& [place, count] : uses) EXPECT_EQ(count % 2, 0);
    }
}

TEST(EdgesWithAdjacency, AreEachEdgeOnce) {
    EXPECT_EQ(edges(tetrahedron(1)).size() / 4, 6U);
    EXPECT_EQ(edges(box(1, 2, 3)).size() / 4, 12U + 6U) << "the diagonals of the faces are edges, too";
    const Mesh ball = sphere(1, 12, 8);
    EXPECT_EQ(edges(ball).size() / 4, ball.indices.size() / 2)
        << "a closed surface has 3/2 edges per triangle";
    EXPECT_EQ(edges(plane(1, 1, 1, 4, 5)).size() / 4, 3U * 4 * 5 + 4 + 5);
}

TEST(EdgesWithAdjacency, HaveTheFarCornersAtTheirEnds) {
    // Two triangles at the edge 1-2: (0, 1, 2) and (2, 1, 3).
    const std::vector<glm::dvec3> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const Mesh mesh = loose(places, {0, 1, 2, 2, 1, 3});
    EXPECT_EQ(edges(mesh), (Indices{2, 0, 1, 2, 0, 1, 2, 5, 1, 2, 0, 1, 3, 4, 5, 3, 4, 5, 3, 4}));
}

TEST(Adjacency, OfNothingIsNothing) {
    EXPECT_TRUE(triangles(Mesh{}).empty());
    EXPECT_TRUE(edges(Mesh{}).empty());
    // A triangle that is a point has no edge.
    const Mesh point = loose({{1, 2, 3}}, {0, 0, 0});
    EXPECT_TRUE(edges(point).empty());
    EXPECT_EQ(triangles(point).size(), 6U);
}

}  // namespace
}  // namespace glibra::geometry
