// glBegin lists: topology words, splitting, dropped vertices, normals, and omitted attributes.

#include "geometry/list_mesh.h"

#include "geometry/frame.h"
#include "mesh_checks.h"

namespace glibra::geometry {
namespace {

std::vector<ListVertex> someVertices(std::size_t count) {
    std::vector<ListVertex> vertices;
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = static_cast<double>(i);
        vertices.push_back({.position = {x, x * x, x * x * x, 1}});
    }
    return vertices;
}

ListMesh list(std::string_view word, std::size_t count, int patchVertices = 3) {
    return meshFromList(word, someVertices(count), false, patchVertices);
}

TEST(ListTopologyWord, IsKnownWithPrefixAndInAnyCase) {
    EXPECT_EQ(listTopology("triangle_strip"), ListTopology::triangleStrip);
    EXPECT_EQ(listTopology("GL_Quad_Strip"), ListTopology::quadStrip);
    EXPECT_EQ(listTopology("gl_lines_adjacency"), ListTopology::linesAdjacency);
    EXPECT_EQ(listTopology("patches"), ListTopology::patches);
    EXPECT_FALSE(listTopology("gl_hexagons"));
    EXPECT_FALSE(listTopology("gl_gl_lines"));
    EXPECT_FALSE(listTopology(""));
    EXPECT_FALSE(listTopology(std::string(100000, 'x')));
}

TEST(ListMesh, SeparatePrimitivesKeepTheirOrder) {
    EXPECT_EQ(list("points", 3).mesh.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(list("lines", 4).mesh.indices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(list("triangles", 6).mesh.indices, (Indices{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(list("lines_adjacency", 4).mesh.indices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(list("triangles_adjacency", 6).mesh.topology, Topology::trianglesAdjacency);
    EXPECT_EQ(list("patches", 8, 4).mesh.patchVertices, 4);
    EXPECT_EQ(list("patches", 8, 4).mesh.topology, Topology::patches);
}

TEST(ListMesh, StripsLoopsAndFansAreSplit) {
    EXPECT_EQ(list("line_strip", 3).mesh.indices, (Indices{0, 1, 1, 2}));
    EXPECT_EQ(list("line_loop", 3).mesh.indices, (Indices{0, 1, 1, 2, 2, 0}));
    EXPECT_EQ(list("triangle_strip", 5).mesh.indices, (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4}));
    EXPECT_EQ(list("triangle_fan", 4).mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(list("polygon", 5).mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 0, 3, 4}));
    EXPECT_EQ(list("quads", 8).mesh.indices, (Indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
    EXPECT_EQ(list("quad_strip", 6).mesh.indices, (Indices{0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4}));
    EXPECT_EQ(list("line_strip_adjacency", 5).mesh.indices, (Indices{0, 1, 2, 3, 1, 2, 3, 4}));
}

TEST(ListMesh, TriangleStripsWithAdjacencyFollowTheTableOfOpenGL) {
    // OpenGL 4.6 core, table 10.1, with vertices counted from 1: strips of one, two and three triangles.
    EXPECT_EQ(list("triangle_strip_adjacency", 6).mesh.indices, (Indices{0, 1, 2, 5, 4, 3}));
    EXPECT_EQ(list("triangle_strip_adjacency", 8).mesh.indices,
              (Indices{0, 1, 2, 6, 4, 3, 4, 0, 2, 5, 6, 7}));
    EXPECT_EQ(list("triangle_strip_adjacency", 10).mesh.indices,
              (Indices{0, 1, 2, 6, 4, 3, 4, 0, 2, 5, 6, 8, 4, 2, 6, 9, 8, 7}));
}

TEST(ListMesh, StripTrianglesKeepOneWinding) {
    std::vector<ListVertex> vertices(9);
    for (std::size_t i = 0; i < 9; ++i)
        vertices[i].position = {static_cast<double>(i) * .5, i % 2 ? 0. : 1., 0, 1};
    const Mesh mesh = meshFromList("triangle_strip", vertices, false, 3).mesh;
    forEachTriangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::dvec3 p = positionAt(mesh, a);
        EXPECT_GT(glm::cross(positionAt(mesh, b) - p, positionAt(mesh, c) - p).z, 0);
    });
}

TEST(ListMesh, AnIncompleteLastPrimitiveIsDropped) {
    struct Case {
        const char* word;
        std::size_t vertices, dropped, indices;
    };
    for (const Case& each : std::initializer_list<Case>{{"points", 1, 0, 1},
                                                        {"lines", 3, 1, 2},
                                                        {"line_strip", 1, 1, 0},
                                                        {"line_loop", 2, 0, 4},
                                                        {"triangles", 5, 2, 3},
                                                        {"triangle_strip", 2, 2, 0},
                                                        {"polygon", 2, 2, 0},
                                                        {"quads", 7, 3, 6},
                                                        {"quads", 3, 3, 0},
                                                        {"quad_strip", 5, 1, 6},
                                                        {"quad_strip", 3, 3, 0},
                                                        {"lines_adjacency", 7, 3, 4},
                                                        {"line_strip_adjacency", 3, 3, 0},
                                                        {"triangles_adjacency", 8, 2, 6},
                                                        {"triangle_strip_adjacency", 7, 1, 6},
                                                        {"triangle_strip_adjacency", 5, 5, 0},
                                                        {"patches", 16, 1, 15}}) {
        const ListMesh mesh = list(each.word, each.vertices, 5);
        EXPECT_EQ(mesh.dropped, each.dropped) << each.word << ' ' << each.vertices;
        EXPECT_EQ(mesh.mesh.indices.size(), each.indices) << each.word << ' ' << each.vertices;
    }
}

TEST(ListMesh, EveryTopologyAndLengthIsInRange) {
    for (const char* word :
         {"points", "lines", "line_strip", "line_loop", "triangles", "triangle_strip", "triangle_fan",
          "polygon", "quads", "quad_strip", "lines_adjacency", "line_strip_adjacency", "triangles_adjacency",
          "triangle_strip_adjacency", "patches"})
        for (std::size_t count = 0; count < 20; ++count) {
            const ListMesh mesh = list(word, count, 7);
            EXPECT_LE(mesh.dropped, count);
            for (const std::uint32_t index : mesh.mesh.indices) EXPECT_LT(index, count);
            EXPECT_EQ(mesh.mesh.indices.size() %
                          static_cast<std::size_t>(verticesPerPrimitive(mesh.mesh.topology, 7)),
                      0U);
        }
}

TEST(ListMesh, TrianglesAndQuadsGetFaceNormals) {
    const std::vector<ListVertex> vertices{{.position = {0, 0, 0, 1}},
                                           {.position = {0, 1, 0, 1}},
                                           {.position = {0, 1, 1, 1}},
                                           {.position = {0, 0, 1, 1}}};
    const Mesh quad = meshFromList("quads", vertices, false, 3).mesh;
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(normalAt(quad, i), glm::dvec3(1, 0, 0));
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(tangentAt(quad, i), glm::dvec3(0, 1, 0));
    const Mesh triangle = meshFromList("triangles", std::span(vertices).first(3), false, 3).mesh;
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(normalAt(triangle, i), glm::dvec3(1, 0, 0));
}

TEST(ListMesh, BentQuadsHaveOneNormalAtAllCorners) {
    const std::vector<ListVertex> vertices{{.position = {0, 0, 0, 1}},
                                           {.position = {1, 0, 0, 1}},
                                           {.position = {1, 1, 1, 1}},
                                           {.position = {0, 1, 0, 1}}};
    const Mesh mesh = meshFromList("quads", vertices, false, 3).mesh;
    for (std::uint32_t i = 0; i < 4; ++i)
        expectNear(normalAt(mesh, i), glm::normalize(glm::dvec3(-1, -1, 2)));
}

TEST(ListMesh, FansGetTheAreaWeightedMean) {
    // Two right triangles at an edge, with areas 1/2 toward +z and 1 toward +x.
    const std::vector<ListVertex> vertices{{.position = {0, 0, 0, 1}},
                                           {.position = {1, 0, 0, 1}},
                                           {.position = {0, 1, 0, 1}},
                                           {.position = {0, 0, -2, 1}}};
    const Mesh mesh = meshFromList("triangle_fan", vertices, false, 3).mesh;
    expectNear(normalAt(mesh, 0), glm::normalize(glm::dvec3(-2, 0, 1)));
    expectNear(normalAt(mesh, 1), {0, 0, 1});
    expectNear(normalAt(mesh, 2), glm::normalize(glm::dvec3(-2, 0, 1)));
    expectNear(normalAt(mesh, 3), {-1, 0, 0});
}

TEST(ListMesh, OtherTopologiesFaceTheViewer) {
    for (const char* word : {"points", "line_strip", "lines_adjacency", "triangles_adjacency", "patches"}) {
        const Mesh mesh = list(word, 6).mesh;
        for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(normalAt(mesh, i), glm::dvec3(0, 0, 1)) << word;
    }
}

TEST(ListMesh, GivenNormalsArePassedOn) {
    std::vector<ListVertex> vertices = someVertices(3);
    vertices[1].normal = {0, 5, 0};
    vertices[2].normal = {0, 0, 0};
    const Mesh mesh = meshFromList("triangles", vertices, true, 3).mesh;
    EXPECT_EQ(normalAt(mesh, 1), glm::dvec3(0, 5, 0));
    EXPECT_EQ(tangentAt(mesh, 1), glm::dvec3(0, 0, -1));
    EXPECT_EQ(normalAt(mesh, 2), glm::dvec3(0, 0, 0));
    EXPECT_EQ(glm::length(tangentAt(mesh, 2)), 1);
}

TEST(ListMesh, FacesWithoutAreaHoldNoNaN) {
    const std::vector<ListVertex> vertices(6);
    for (const char* word : {"triangles", "quads", "triangle_strip", "polygon"})
        expectSound(meshFromList(word, vertices, false, 3).mesh);
}

TEST(ListMesh, LeavesOutWhatDoesNotVary) {
    std::vector<ListVertex> vertices = someVertices(3);
    for (ListVertex& vertex : vertices) vertex.color = {1, 0, 0, 1};
    ListMesh mesh = meshFromList("triangles", vertices, false, 3);
    EXPECT_EQ(mesh.mesh.attribute(kColor), nullptr);
    EXPECT_EQ(mesh.color, (std::array<double, 4>{1, 0, 0, 1}));
    EXPECT_EQ(mesh.mesh.attribute(kTexCoord), nullptr);
    EXPECT_EQ(mesh.mesh.attribute(kPosition)->components, 3);

    vertices[1].color = {0, 1, 0, .5};
    vertices[1].position[3] = 2;
    vertices[1].texCoord = {.5, 0, 0, 1};
    mesh = meshFromList("triangles", vertices, false, 3);
    EXPECT_EQ(mesh.mesh.attribute(kColor)->values, (std::vector<float>{1, 0, 0, 1, 0, 1, 0, .5, 1, 0, 0, 1}));
    EXPECT_FALSE(mesh.color);
    EXPECT_EQ(mesh.mesh.attribute(kTexCoord)->components, 2);
    EXPECT_EQ(mesh.mesh.attribute(kPosition)->components, 4);
    EXPECT_EQ(mesh.mesh.attribute(kPosition)->values[7], 2);

    vertices[2].texCoord[2] = .25;
    EXPECT_EQ(meshFromList("triangles", vertices, false, 3).mesh.attribute(kTexCoord)->components, 3);
    vertices[0].texCoord[3] = 0;
    EXPECT_EQ(meshFromList("triangles", vertices, false, 3).mesh.attribute(kTexCoord)->components, 4);
}

TEST(ListMesh, HomogeneousPointsHaveTheNormalOfTheirPlaces) {
    // The triangle (0,0,0) (1,0,0) (0,1,0), two corners scaled.
    const std::vector<ListVertex> vertices{
        {.position = {0, 0, 0, 3}}, {.position = {2, 0, 0, 2}}, {.position = {0, -1, 0, -1}}};
    const Mesh mesh = meshFromList("triangles", vertices, false, 3).mesh;
    EXPECT_EQ(normalAt(mesh, 0), glm::dvec3(0, 0, 1));
}

TEST(TrianglesCommand, HasFaceNormalsAndUnitTextureCoordinates) {
    const std::vector<std::array<double, 4>> points{{0, 0, 0, 1}, {0, 0, 2, 1}, {2, 0, 0, 1}};
    const Mesh mesh = trianglesList(points);
    EXPECT_EQ(countsOf(mesh), (Counts{3, 1}));
    EXPECT_EQ(normalAt(mesh, 0), glm::dvec3(0, 1, 0));
    EXPECT_EQ(tangentAt(mesh, 0), glm::dvec3(0, 0, -1));
    EXPECT_EQ(texCoordAt(mesh, 0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(texCoordAt(mesh, 1), glm::dvec3(1, 0, 0));
    EXPECT_EQ(texCoordAt(mesh, 2), glm::dvec3(0, 1, 0));
}

TEST(LinesAdjacencyCommand, FacesTheViewer) {
    const std::vector<std::array<double, 4>> points{{0, 0, 0, 1}, {0, 0, 2, 1}, {2, 0, 0, 1}, {2, 2, 0, 1}};
    const Mesh mesh = linesAdjacencyList(points);
    EXPECT_EQ(mesh.topology, Topology::linesAdjacency);
    EXPECT_EQ(countsOf(mesh), (Counts{4, 1}));
    EXPECT_EQ(normalAt(mesh, 3), glm::dvec3(0, 0, 1));
    EXPECT_EQ(mesh.attribute(kTexCoord), nullptr);
}

}  // namespace
}  // namespace glibra::geometry
