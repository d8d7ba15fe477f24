// Meshes of OBJ models: vertices, normals, tangents, adjacency, edges.

#include "geometry/obj/obj_model.h"

#include <algorithm>
#include <set>
#include <string>

#include "geometry/frame.h"
#include "geometry/mix.h"
#include "geometry/shapes/spheres.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

ObjModel model(std::string_view text) {
    auto parsed = parseObj(text, "test.obj");
    EXPECT_TRUE(parsed);
    return parsed ? std::move(*parsed) : ObjModel{};
}

constexpr const char* kQuad = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";

/// Returns an OBJ text for a mesh. Each vertex becomes v, vt and vn with the same number.
std::string textOf(const Mesh& mesh, bool withNormals, bool withTexCoords) {
    std::string text;
    const auto line = [&](const char* word, const glm::dvec3& v) {
        text += std::string(word) + ' ' + std::to_string(v.x) + ' ' + std::to_string(v.y) + ' ' +
                std::to_string(v.z) + '\n';
    };
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        line("v", positionAt(mesh, i));
        line("vt", texCoordAt(mesh, i));
        line("vn", normalAt(mesh, i));
    }
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        text += 'f';
        for (const std::uint32_t vertex : {a, b, c}) {
            const std::string index = std::to_string(vertex + 1);
            text += ' ' + index + '/' + (withTexCoords ? index : "") + '/' + (withNormals ? index : "");
        }
        text += '\n';
    });
    return text;
}

TEST(ObjMesh, PolygonsBecomeFans) {
    const Mesh mesh = obj(model("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n"));
    EXPECT_EQ(countsOf(mesh), (Counts{5, 3}));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    expectSound(mesh);
}

TEST(ObjMesh, HoldsOneVertexForEachDifferentTriple) {
    const Mesh mesh = obj(model(std::string(kQuad) +
                                "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 1 0\n"
                                "f 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\nf 1/2/1 2/1/1 3/1/2\nf 1 2 3\n"));
    EXPECT_EQ(countsOf(mesh), (Counts{4 + 2 + 3, 4}));
}

TEST(ObjMesh, NormalsOfTheFileAreMadeUnit) {
    const Mesh mesh =
        obj(model(std::string(kQuad) + "vn 0 3 4\nvn 1e-30 0 0\nvn 3e38 0 3e38\nf 1//1 2//2 3//3\n"));
    expectNear(normalAt(mesh, 0), {0, .6, .8});
    expectNear(normalAt(mesh, 1), {1, 0, 0});
    expectNear(normalAt(mesh, 2), {std::sqrt(.5), 0, std::sqrt(.5)});
}

TEST(ObjMesh, MissingNormalsAreTheAreaWeightedMeanAtThePosition) {
    // A triangle of area 1/2 toward +z and one of area 1 toward -x at the edge 1-3; vertex 1 has two texture
    // coordinates.
    const Mesh mesh =
        obj(model("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -2\nvt 0 0\nvt 1 1\nvn 0 1 0\n"
                  "f 1/1 2/1 3/1\nf 1/2 3/1 4/1\nf 1//1 2//1 3//1\n"));
    // The third face is also part of the mean: area 1/2 toward +z again.
    const glm::dvec3 mean = glm::normalize(glm::dvec3(-2, 0, 2));
    expectNear(normalAt(mesh, 0), mean);
    expectNear(normalAt(mesh, 1), {0, 0, 1});
    expectNear(normalAt(mesh, 2), mean);
    expectNear(normalAt(mesh, 3), mean);
    expectNear(normalAt(mesh, 4), {-1, 0, 0});
    expectNear(normalAt(mesh, 5), {0, 1, 0});
}

TEST(ObjMesh, AZeroNormalCountsAsMissing) {
    const Mesh mesh = obj(model(std::string(kQuad) + "vn 0 0 0\nvn -0 0 -0\nf 1//1 2//2 3//1\n"));
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, 0, 1));
}

TEST(ObjMesh, DegenerateFacesAndSheetsHoldNoNaN) {
    expectSound(obj(model(std::string(kQuad) + "vt 0 0\nf 1/1 1/1 1/1\nf 2/1 2/1 3/1\n")));
    // Both sides of one triangle cancel; the first face decides.
    const Mesh sheet = obj(model(std::string(kQuad) + "f 1 2 3\nf 3 2 1\n"));
    expectSound(sheet);
    EXPECT_EQ(normalAt(sheet, 0), glm::dvec3(0, 0, 1));
    expectSound(obj(model("v 3e38 0 0\nv -3e38 0 0\nv 0 3e38 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n")));
}

TEST(ObjMesh, TextureCoordinatesAreLeftOutWhereTheFileHasNone) {
    EXPECT_EQ(obj(model(std::string(kQuad) + "f 1 2 3 4")).attribute(kTexCoord), nullptr);
    const Mesh mixed = obj(model(std::string(kQuad) + "vt .5 .5\nf 1/1 2 3\n"));
    EXPECT_EQ(mixed.attribute(kTexCoord)->values, (std::vector<float>{.5F, .5F, 0, 0, 0, 0}));
    EXPECT_EQ(obj(model(std::string(kQuad) + "vt 0 0 .5\nf 1/1 2/1 3/1\n")).attribute(kTexCoord)->components,
              3);
}

TEST(ObjMesh, TangentsPointAlongGrowingT) {
    // t grows along -x: the picture is turned.
    const Mesh mesh = obj(model(std::string(kQuad) + "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3 4/4\n"));
    for (std::uint32_t i = 0; i < 4; ++i) expectNear(tangentAt(mesh, i), {-1, 0, 0});
    const Mesh mirrored =
        obj(model(std::string(kQuad) + "vt 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3 4/4\n"));
    for (std::uint32_t i = 0; i < 4; ++i) expectNear(tangentAt(mirrored, i), {0, 1, 0});
}

TEST(ObjMesh, UndefinedTangentsFallBack) {
    for (const char* faces :
         {"f 1 2 3 4\n", "vt 0 0\nf 1/1 2/1 3/1 4/1\n", "vt 0 0\nvt 1 1\nvt 2 2\nf 1/1 2/2 3/3\n"}) {
        const Mesh mesh = obj(model(std::string(kQuad) + faces));
        for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i)
            EXPECT_EQ(tangentAt(mesh, i), fallbackTangent(normalAt(mesh, i)));
    }
}

TEST(ObjMesh, TangentsAndNormalsOfASphereComeBack) {
    const Mesh original = sphere(1, 64, 64);
    const Mesh mesh = obj(model(textOf(original, false, true)));
    expectSound(mesh);
    // Vertices are numbered by first use. They are found again by position and texture coordinate, which are
    // those of the file.
    int compared = 0;
    for (std::uint32_t i = 0; i < mesh.vertexCount(); ++i) {
        const glm::dvec3 st = texCoordAt(mesh, i), p = positionAt(mesh, i);
        if (std::abs(p.y) > .9 || st.x < .01 || st.x > .99) continue;
        EXPECT_GT(glm::dot(normalAt(mesh, i), p), .9999);
        EXPECT_GT(glm::dot(tangentAt(mesh, i), fallbackTangent(p)), .999);
        ++compared;
    }
    EXPECT_GT(compared, 2000);
}

TEST(ObjMesh, TangentsAreLeftOutOnRequest) {
    const ObjModel quad = model(std::string(kQuad) + "f 1 2 3 4\n");
    EXPECT_EQ(obj(quad, false).attribute(kTangent), nullptr);
    EXPECT_EQ(obj(quad, false).indices, obj(quad).indices);
}

TEST(ObjMesh, PatchesAreTheTriangles) {
    const ObjModel quad = model(std::string(kQuad) + "f 1 2 3 4\n");
    const Mesh patches = objPatch(quad);
    EXPECT_EQ(patches.topology, Topology::patches);
    EXPECT_EQ(patches.patchVertices, 3);
    EXPECT_EQ(patches.indices, obj(quad).indices);
}

TEST(ObjMesh, OneFileMayMixAllFaceForms) {
    // A house: a wall of five corners with texture coordinates and normals, a floor with normals and negative
    // indices, a side with texture coordinates only, a roof with positions only; groups and materials
    // between.
    const Mesh mesh =
        obj(model("mtllib house.mtl\no house\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n"
                  "vt 0 0\nvt 1 0\nvt 1 .5\nvt .5 1\nvt 0 .5\nvn 0 0 2\ng wall\nusemtl brick\ns off\n"
                  "f 1/1/1 2/2/1 3/3/1 4/4/1 5/5/1\ns 1\n"
                  "v 0 0 -3\nv 2 0 -3\nv 2 1 -3\nv 1 2 -3\nvn 0 -1 0\ng floor\nf 1//-1 -4//-1 -3//-1 2//-1\n"
                  "g side\nf 2/-5 7/-4 8/-3 3/-2\ng roof\nf 3 8 9 4\n"));
    EXPECT_EQ(countsOf(mesh), stated(5 + 4 + 4 + 4, 3 + 2 + 2 + 2));
    expectSound(mesh);
    EXPECT_EQ(wronglyWound(mesh), 0U);
    for (std::uint32_t i = 0; i < 5; ++i) expectNear(normalAt(mesh, i), {0, 0, 1});
    for (std::uint32_t i = 5; i < 9; ++i) {
        expectNear(normalAt(mesh, i), {0, -1, 0});
        EXPECT_EQ(texCoordAt(mesh, i), glm::dvec3(0));
    }
    expectNear(positionAt(mesh, 6), {0, 0, -3});
    expectNear(positionAt(mesh, 7), {2, 0, -3});
    // Corner 7 belongs to the floor and the side, of areas 6 and 3; only the side's corner lacks a normal.
    expectNear(normalAt(mesh, 10), glm::normalize(glm::dvec3(3, -6, 0)));
    expectNear(texCoordAt(mesh, 10), {1, 0, 0});
    // Corner 9 belongs to the roof alone.
    expectNear(normalAt(mesh, 15), glm::normalize(glm::dvec3(1, 1, 0)));
}

/// Two slopes of 45 degrees that meet in x = 0.
constexpr const char* kRoof = "v -1 0 0\nv 0 0 1\nv 0 1 1\nv -1 1 0\nv 1 0 0\nv 1 1 0\n";

TEST(ObjMesh, OnlyFacesOfOneSmoothingGroupShareNormals) {
    const double slope = std::sqrt(.5);
    const auto normalsOf = [](const std::string& text) {
        const Mesh mesh = obj(model(kRoof + text));
        std::vector<glm::dvec3> normals;
        for (const std::uint32_t each : mesh.indices) normals.push_back(normalAt(mesh, each));
        return normals;
    };
    const std::string left = "f 1 2 3 4\n", right = "f 2 5 6 3\n";
    // The corners in the order of two fans; those of the ridge are 1, 2, 4 of the left, 0, 3, 5 of the right.
    for (const std::string& text :
         {"s 1\n" + left + "s 2\n" + right, "s off\n" + left + right, "s 0\n" + left + right,
          left + "s 3\n" + right, "s 7\n" + left + "s off\n" + right,
          "s 12\r\n" + left + "s 11\t\n" + right}) {
        const std::vector<glm::dvec3> normals = normalsOf(text);
        ASSERT_EQ(normals.size(), 12U);
        for (std::size_t i = 0; i < 12; ++i) expectNear(normals[i], {i < 6 ? -slope : slope, 0, slope});
    }
    for (const std::string& text :
         {left + right, "s 1\n" + left + right, "s 1\n" + left + "s 2\ns 1\n" + right, left + right + "s 1\n",
          "s on\n" + left + "s 1\n" + right}) {
        const std::vector<glm::dvec3> normals = normalsOf(text);
        expectNear(normals[0], {-slope, 0, slope});
        expectNear(normals[1], {0, 0, 1});
        expectNear(normals[6], {0, 0, 1});
    }
}

TEST(ObjMesh, FilesWithOneGroupAreFilesWithoutGroups) {
    const std::string ball = textOf(sphere(1, 12, 8), false, true);
    const Mesh plain = obj(model(ball)), grouped = obj(model("s 5\n" + ball));
    EXPECT_EQ(plain.indices, grouped.indices);
    ASSERT_EQ(plain.attributes.size(), grouped.attributes.size());
    for (std::size_t i = 0; i < plain.attributes.size(); ++i)
        EXPECT_EQ(plain.attributes[i].values, grouped.attributes[i].values);
}

TEST(ObjMesh, GroupsDoNotChangeNormalsOfTheFile) {
    const std::string ball = textOf(sphere(1, 12, 8), true, true);
    std::string grouped;
    int faces = 0;
    for (std::size_t at = 0, end; at < ball.size(); at = end + 1) {
        end = ball.find('\n', at);
        if (ball[at] == 'f') grouped += faces++ % 2 == 0 ? "s off\n" : "s 4\n";
        grouped += ball.substr(at, end + 1 - at);
    }
    const Mesh one = obj(model(ball)), other = obj(model(grouped));
    EXPECT_EQ(one.indices, other.indices);
    EXPECT_EQ(one.attribute(kNormal)->values, other.attribute(kNormal)->values);
}

TEST(ObjMesh, ColoursOfVerticesAreTheirOwnAttribute) {
    EXPECT_EQ(obj(model(std::string(kQuad) + "f 1 2 3 4\n")).attribute(kColor), nullptr);
    EXPECT_EQ(obj(model("v 0 0 0 1\nv 1 0 0 .5\nv 0 1 0 2\nf 1 2 3\n")).attribute(kColor), nullptr);
    const Mesh mesh = obj(model("v 0 0 0 1 .5 0\nv 1 0 0\nv 0 1 0 .25 0 1 .5\nv 1 1 0\nf 3 1 2 4\n"));
    ASSERT_NE(mesh.attribute(kColor), nullptr);
    EXPECT_EQ(mesh.attribute(kColor)->components, 4);
    EXPECT_EQ(mesh.attribute(kColor)->values,
              (std::vector<float>{.25F, 0, 1, 1, 1, .5F, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(ObjAdj, NamesTheFarCornersOfTheNeighbours) {
    // The edge 1-3 is inside; all others are borders, whose far corner is the edge's first vertex.
    const Mesh mesh = objAdj(model(std::string(kQuad) + "f 1 2 3\nf 1 3 4\n"));
    EXPECT_EQ(mesh.topology, Topology::trianglesAdjacency);
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 3, 0, 1, 2, 2, 3, 3}));
}

TEST(ObjAdj, FindsNeighboursAcrossSeamsByPosition) {
    // The second triangle has vertices of its own at the same positions, one of them with a negative zero.
    const Mesh mesh =
        objAdj(model("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 -0 0\nv 0 1 -0\nv -1 0 0\nf 1 2 3\nf 4 5 6\n"));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 5, 3, 1, 4, 4, 5, 5}));
}

TEST(ObjAdj, EdgesOfThreeFacesTakeTheFirstOtherInFileOrder) {
    const Mesh mesh =
        objAdj(model("v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"));
    EXPECT_EQ(mesh.indices[1], 3U);
    EXPECT_EQ(mesh.indices[7], 2U);
    EXPECT_EQ(mesh.indices[13], 2U);
}

/// Finds the far corner across side `side` of triangle `triangle` by trying all other triangles.
std::uint32_t bruteForceNeighbour(const Mesh& mesh, std::size_t triangle, std::size_t side) {
    const auto corner = [&](std::size_t t, std::size_t c) { return mesh.indices[6 * t + 2 * (c % 3)]; };
    const auto place = [&](std::size_t t, std::size_t c) { return positionAt(mesh, corner(t, c)); };
    const glm::dvec3 a = place(triangle, side), b = place(triangle, side + 1);
    if (a == b) return corner(triangle, side);
    for (std::size_t other = 0; other < mesh.indices.size() / 6; ++other) {
        if (other == triangle) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const glm::dvec3 p = place(other, c), q = place(other, c + 1);
            if ((p == a && q == b) || (p == b && q == a)) return corner(other, c + 2);
        }
    }
    return corner(triangle, side);
}

TEST(ObjAdj, AgreesWithBruteForceOnTangledModels) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        // Triangles among a few places: many borders, many edges with three faces or more, some without area.
        const std::uint32_t places = 4 + seed * 3;
        const auto random = [&](std::uint32_t i) { return mix(mix(i) + seed * 7919); };
        std::string text;
        for (std::uint32_t i = 0; i < places; ++i)
            text += "v " + std::to_string(random(i) % 3) + ' ' + std::to_string(random(i + 1000) % 3) + ' ' +
                    std::to_string(random(i + 2000) % 2) + '\n';
        for (std::uint32_t i = 0; i < 60; ++i) {
            text += 'f';
            for (std::uint32_t c = 0; c < 3 + random(i + 9000) % 3; ++c)
                text += ' ' + std::to_string(1 + random(5000 + 10 * i + c) % places);
            text += '\n';
        }
        const Mesh mesh = objAdj(model(text));
        ASSERT_EQ(mesh.indices.size() % 6, 0U);
        for (std::size_t triangle = 0; triangle < mesh.indices.size() / 6; ++triangle)
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t expected = bruteForceNeighbour(mesh, triangle, side);
                const std::uint32_t found = mesh.indices[6 * triangle + 2 * side + 1];
                // A degenerate neighbour has two equal edges. Either may be used; both give the same place.
                EXPECT_EQ(positionAt(mesh, found), positionAt(mesh, expected))
                    << seed << ' ' << triangle << ' ' << side;
            }
    }
}

TEST(ObjAdj, AClosedModelHasNoBorder) {
    const Mesh mesh = objAdj(model(textOf(sphere(1, 12, 8), true, true)));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 2) EXPECT_NE(mesh.indices[i], mesh.indices[i + 1]);
}

TEST(WireObj, DrawsEveryPolygonEdgeOnce) {
    const Mesh mesh =
        wireObj(model("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvt 0 0\nvt 1 1\n"
                      "f 1/1 2/1 3/1 4/1\nf 2/2 5/2 6/2 3/2\nf 1 1 2\n"));
    EXPECT_EQ(mesh.topology, Topology::lines);
    EXPECT_EQ(mesh.indices.size() / 2, 7U);
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    const std::vector<std::uint32_t> welded = weldedByBits(mesh);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 2)
        EXPECT_TRUE(seen.insert(std::minmax(welded[mesh.indices[i]], welded[mesh.indices[i + 1]])).second);
}

TEST(WireObj, DrawsLinesAndPoints) {
    const auto parsed = parseObj(
        std::string(kQuad) + "vt .5 .5\nl 1/1 2/1 3/1\nl 4 -3 4\np 1 3\np 4\nf 1 2 3\nl 9 1\nl 1\np 7\n",
        "a.obj", ObjElements::edges);
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed.diagnostics.size(), 3U);
    for (const Diagnostic& each : parsed.diagnostics) EXPECT_EQ(each.id, "file-W05");
    const Mesh mesh = wireObj(*parsed);
    expectSound(mesh);
    EXPECT_EQ(mesh.pointCount, 3U);
    ASSERT_EQ(mesh.indices.size(), 2 * 4 + 3U);
    std::vector<std::pair<glm::dvec3, glm::dvec3>> edges;
    for (std::size_t i = 0; i + 3 < mesh.indices.size(); i += 2)
        edges.emplace_back(positionAt(mesh, mesh.indices[i]), positionAt(mesh, mesh.indices[i + 1]));
    // Those of the face, then what the lines add.
    const glm::dvec3 a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0};
    EXPECT_EQ(edges, (std::vector<std::pair<glm::dvec3, glm::dvec3>>{{a, b}, {b, c}, {c, a}, {d, b}}));
    EXPECT_EQ(positionAt(mesh, mesh.indices[8]), a);
    EXPECT_EQ(positionAt(mesh, mesh.indices[9]), c);
    EXPECT_EQ(positionAt(mesh, mesh.indices[10]), d);
}

TEST(WireObj, NeedsNoFaces) {
    for (const char* text : {"v 0 0 0\nv 1 0 0\nl 1 2\n", "v 0 0 0\np 1\n", "l 1 2\nv 0 0 0\nv 1 0 0\n"}) {
        const auto parsed = parseObj(text, "a.obj", ObjElements::edges);
        ASSERT_TRUE(parsed) << text;
        EXPECT_TRUE(parsed.diagnostics.empty());
        expectSound(wireObj(*parsed));
        EXPECT_FALSE(wireObj(*parsed).indices.empty());
        const auto faces = parseObj(text, "a.obj");
        ASSERT_FALSE(faces);
        EXPECT_EQ(faces.diagnostics.back().text, "'a.obj' has no faces; WireObj draws its lines and points");
    }
    const auto nothing = parseObj("v 0 0 0\n", "a.obj", ObjElements::edges);
    ASSERT_FALSE(nothing);
    EXPECT_EQ(nothing.diagnostics.back().text, "'a.obj' has no faces, lines or points");
}

TEST(WireObj, OfAClosedModelFollowsEuler) {
    const ObjModel ball = model(textOf(sphere(1, 12, 8), true, true));
    const Mesh mesh = wireObj(ball);
    // Seams are open by position index: 13 columns, 12 poles at each end.
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t face = 0; face < ball.faceCount(); ++face)
        for (std::uint32_t i = 0; i < 3; ++i)
            edges.insert(std::minmax(ball.corners[3 * face + i].position,
                                     ball.corners[3 * face + (i + 1) % 3].position));
    EXPECT_EQ(mesh.indices.size() / 2, edges.size());
}

}  // namespace
}  // namespace glibra::geometry
