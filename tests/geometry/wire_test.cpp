// Wire forms: the number of segments, that each occurs once, and that their vertices are those of the solids.

#include <algorithm>
#include <set>

#include "geometry/frame.h"
#include "geometry/shapes/cylinders.h"
#include "geometry/shapes/polyhedra.h"
#include "geometry/shapes/spheres.h"
#include "geometry/shapes/teapot.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

struct Wire {
    const char* name;
    Mesh wire;
    int segments;
};

std::vector<Wire> wires() {
    return {{"sphere", wireSphere(1.3, 20, 20), 20 * 39},
            {"least sphere", wireSphere(1, 3, 2), 9},
            {"cylinder", wireCylinder(1, 1, 20, 5), 20 * 11},
            {"least cylinder", wireCylinder(1, 1, 3, 1), 9},
            {"cone", wireCone(1, 1, 20, 5), 200},
            {"least cone", wireCone(1, 1, 3, 1), 6},
            {"torus", wireTorus(1, .5, 20, 40), 1600},
            {"least torus", wireTorus(1, .5, 3, 3), 18},
            {"box", wireBox(1, 2, 3), 12}};
}

TEST(Wire, FormsHaveTheStatedSegments) {
    for (const Wire& each : wires()) {
        EXPECT_EQ(countsOf(each.wire).primitives, static_cast<std::uint64_t>(each.segments)) << each.name;
        EXPECT_EQ(each.wire.topology, Topology::lines);
        expectSound(each.wire);
    }
}

TEST(Wire, FormsAreAsLargeAsTheClosedFormsSay) {
    EXPECT_EQ(countsOf(wireSphere(1, 7, 5)), wireSphereCounts(7, 5));
    EXPECT_EQ(countsOf(wireCylinder(1, 1, 7, 5)), wireCylinderCounts(7, 5));
    EXPECT_EQ(countsOf(wireCone(1, 1, 7, 5)), wireConeCounts(7, 5));
    EXPECT_EQ(countsOf(wireTorus(1, .5, 7, 5)), wireTorusCounts(7, 5));
    EXPECT_EQ(countsOf(wireBox(1, 1, 1)), wireBoxCounts());
}

TEST(Wire, EverySegmentIsDrawnOnce) {
    for (const Wire& each : wires()) {
        const std::vector<std::uint32_t> welded = weldedByBits(each.wire);
        std::set<std::pair<std::uint32_t, std::uint32_t>> segments;
        for (std::size_t i = 0; i < each.wire.indices.size(); i += 2) {
            const std::uint32_t a = welded[each.wire.indices[i]], b = welded[each.wire.indices[i + 1]];
            EXPECT_NE(a, b) << each.name;
            EXPECT_TRUE(segments.insert(std::minmax(a, b)).second) << each.name;
        }
    }
}

TEST(Wire, SegmentsAreTheSolidsEdgesWithoutDiagonalsAndCaps) {
    const auto edgesOf = [](const Mesh& mesh, std::size_t corners) {
        std::set<std::pair<PositionBits, PositionBits>> edges;
        const Attribute& position = *mesh.attribute(kPosition);
        const auto bits = [&](std::uint32_t v) {
            PositionBits all;
            for (std::size_t c = 0; c < 3; ++c)
                all[c] = std::bit_cast<std::uint32_t>(position.values[3 * std::size_t{v} + c]);
            return all;
        };
        for (std::size_t i = 0; i < mesh.indices.size(); i += corners)
            for (std::size_t c = 0; c < (corners == 2 ? 1 : corners); ++c)
                edges.insert(
                    std::minmax(bits(mesh.indices[i + c]), bits(mesh.indices[i + (c + 1) % corners])));
        return edges;
    };
    const std::vector<std::pair<Mesh, Mesh>> pairs{{wireSphere(1.3, 9, 7), sphere(1.3, 9, 7)},
                                                   {wireCylinder(1.3, 2, 9, 7), cylinder(1.3, 2, 9, 7)},
                                                   {wireCone(1.3, 2, 9, 7), cone(1.3, 2, 9, 7)},
                                                   {wireTorus(1.3, .2, 9, 7), torus(1.3, .2, 9, 7)}};
    for (const auto& [wire, solid] : pairs) {
        const auto some = edgesOf(wire, 2), all = edgesOf(solid, 3);
        EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    }
}

TEST(Wire, BoxCornersCarryDiagonalsAndUnitTextureCoordinates) {
    const Mesh mesh = wireBox(2, 2, 2);
    EXPECT_EQ(mesh.vertexCount(), 8U);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const glm::dvec3 p = positionAt(mesh, i);
        expectNear(normalAt(mesh, i), glm::normalize(p));
        expectNear(tangentAt(mesh, i), fallbackTangent(p));
        EXPECT_EQ(texCoordAt(mesh, i), (p + 1.0) / 2.0);
    }
}

TEST(Wire, TeapotSegmentsAllHaveLength) {
    const Mesh mesh = wireTeapot();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 2)
        EXPECT_GT(glm::distance(positionAt(mesh, mesh.indices[i]), positionAt(mesh, mesh.indices[i + 1])),
                  1e-4);
}

}  // namespace
}  // namespace glibra::geometry
