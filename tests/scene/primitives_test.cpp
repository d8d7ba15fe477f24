// Every geometry command gives the mesh that its row describes (language, 3.3, 4.2 to 4.6).

#include "scene/primitives.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "scene/actions.h"
#include "scene/run/statements.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::idsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

struct Expected {
    const char* text;
    int vertices;
    int indices;
    geometry::Topology topology;
};
using enum geometry::Topology;

// The formulas of the tables in language, 4, evaluated by hand for sizes other than the defaults.
const Expected kShapes[] = {
    {"Box 1 2 3", 24, 36, triangles},
    {"Cube 3", 24, 36, triangles},
    {"Sphere 1 8 6", 9 * 5 + 16, 3 * 16 * 5, triangles},
    {"Sphere", 61 * 59 + 120, 3 * 120 * 59, triangles},
    {"Cylinder 1 2 8 6", 9 * 7 + 32 + 2, 3 * (2 * 48 + 16), triangles},
    {"Cone 1 2 8 6", 9 * 6 + 24 + 1, 3 * 2 * 48, triangles},
    {"Torus 1 .5 8 6", 7 * 9, 3 * 2 * 48, triangles},
    {"Teapot", 9248, 3 * 16256, triangles},
    {"Soccerball 2", 8100, 3 * 11520, triangles},
    {"DiskXY 0 1 8 6", 9 * 6 + 8, 3 * 8 * 11, triangles},
    {"QuadXY 0 1 8 6", 9 * 7, 3 * 2 * 48, triangles},
    {"QuadXZ 0 1 8 6", 9 * 7, 3 * 2 * 48, triangles},
    {"QuadYZ 0 1 8 6", 9 * 7, 3 * 2 * 48, triangles},
    {"QuadBox 7", 28, 3 * 14, triangles},
    {"Xarrow 10", 250 + 148, 3 * (480 + 48), triangles},
    {"PointCloud 2 3 4", 24, 24, points},
    {"JitterCloud 2 3 4 5", 24, 24, points},
    {"WireSphere 1 8 6", 9 * 5 + 16, 2 * 8 * 11, lines},
    {"WireTorus 1 .5 8 6", 7 * 9, 2 * 2 * 48, lines},
    {"WireCylinder 1 2 8 6", 9 * 7, 2 * 8 * 13, lines},
    {"WireCone 1 2 8 6", 9 * 6 + 8, 2 * 2 * 48, lines},
    {"WireCube", 8, 24, lines},
    {"WireBox 1 2 3", 8, 24, lines},
    {"WireTeapot", 32 * 81, 2 * 4544, lines},
    {"FullScreen", 4, 6, triangles},
    {"SkyBox 4", 24, 36, triangles},
    {"Triangles 0 0 0 1 0 0 0 1 0", 3, 3, triangles},
    {"LinesAdjacency 0 0 0 1 0 0 2 0 0 3 0 0", 4, 4, linesAdjacency},
};

TEST(Commands, EachHasAnAction) {
    for (const glib::StatementRow& row : glib::commandTable())
        EXPECT_NE(actionOf(allActions(), row.id), nullptr)
            << row.name << ": list its action at the end of its file";
    for (const glib::StatementRow& row : glib::statementTable())
        EXPECT_NE(actionOf(allActions(), row.id), nullptr)
            << row.name << ": list its action at the end of its file";
    constexpr int kFirst = static_cast<int>(glib::CommandId::firstPrimitive);
    EXPECT_EQ(actionOf(allActions(), static_cast<glib::CommandId>(
                                         kFirst + static_cast<int>(geometry::primitives().size()))),
              nullptr);
}

TEST(Primitives, MeshesHaveTheSizesOfTheLanguage) {
    for (const Expected& each : kShapes) {
        const Scene scene = run(std::string(each.text) + "\n");
        ASSERT_EQ(scene.shapes.size(), 1U) << each.text;
        EXPECT_EQ(topologyOf(scene.shapes.at(0)), each.topology) << each.text;
        const auto mesh = makeMesh(scene, ShapeIndex(0));
        ASSERT_TRUE(mesh) << each.text;
        EXPECT_EQ(static_cast<int>(mesh->vertexCount()), each.vertices) << each.text;
        EXPECT_EQ(static_cast<int>(mesh->indices.size()), each.indices) << each.text;
        EXPECT_EQ(mesh->topology, each.topology) << each.text;
        const auto counts = countsOf(scene.shapes.at(0));
        ASSERT_TRUE(counts) << each.text;
        EXPECT_EQ(static_cast<int>(counts->vertices), each.vertices) << each.text;
        EXPECT_EQ(static_cast<int>(counts->primitives) * geometry::verticesPerPrimitive(each.topology),
                  each.indices)
            << each.text;
    }
}

/// The smallest and the largest coordinate of a mesh along each axis.
struct Extent {
    glm::dvec3 low{1e9}, high{-1e9};
};
Extent extentOf(std::string_view text) {
    Extent extent;
    const auto mesh = makeMesh(run(text), ShapeIndex(0));
    const geometry::Attribute* position = mesh ? mesh->attribute(geometry::kPosition) : nullptr;
    if (position == nullptr) return extent;
    const auto stride = static_cast<std::size_t>(position->components);
    for (std::size_t i = 0; i < position->values.size(); ++i) {
        const auto axis = static_cast<int>(i % stride);
        if (axis > 2) continue;
        extent.low[axis] = std::min(extent.low[axis], static_cast<double>(position->values[i]));
        extent.high[axis] = std::max(extent.high[axis], static_cast<double>(position->values[i]));
    }
    return extent;
}
void expectExtent(std::string_view text, const glm::dvec3& low, const glm::dvec3& high) {
    const Extent extent = extentOf(text);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(extent.low[i], low[i], 1e-6) << text << " axis " << i;
        EXPECT_NEAR(extent.high[i], high[i], 1e-6) << text << " axis " << i;
    }
}

TEST(Primitives, ArgumentsReachTheirShapesInOrder) {
    expectExtent("Box 1 2 3\n", {-.5, -1, -1.5}, {.5, 1, 1.5});
    expectExtent("Sphere 2 8 6\n", {-2, -2, -2}, {2, 2, 2});
    expectExtent("Cylinder 2 3 8 6\n", {-2, 0, -2}, {2, 3, 2});
    expectExtent("Cone 2 3 8 6\n", {-2, 0, -2}, {2, 3, 2});
    expectExtent("Torus .5 2 8 4\n", {-2.5, -2.5, -.5}, {2.5, 2.5, .5});
    expectExtent("Soccerball 3\n", {-3, -3, -3}, {3, 3, 3});
    expectExtent("DiskXY -4 2 8 6\n", {-2, -2, -4}, {2, 2, -4});
    expectExtent("QuadXY -4 2\n", {-2, -2, -4}, {2, 2, -4});
    expectExtent("QuadXZ -4 2\n", {-2, -4, -2}, {2, -4, 2});
    expectExtent("QuadYZ -4 2\n", {-4, -2, -2}, {-4, 2, 2});
    expectExtent("QuadBox 3\n", {-1, -1, -1}, {1, 1, 1});
    expectExtent("PointCloud 3 1 2\n", {-1, 0, -1}, {1, 0, 1});
    expectExtent("WireSphere 2 8 6\n", {-2, -2, -2}, {2, 2, 2});
    expectExtent("WireTorus 2 .5 8 4\n", {-2.5, -2.5, -.5}, {2.5, 2.5, .5});
    expectExtent("WireCylinder 2 3 8 6\n", {-2, 0, -2}, {2, 3, 2});
    expectExtent("WireCone 2 3 8 6\n", {-2, 0, -2}, {2, 3, 2});
    expectExtent("WireCube 4\n", {-2, -2, -2}, {2, 2, 2});
    expectExtent("WireBox 1 2 3\n", {-.5, -1, -1.5}, {.5, 1, 1.5});
    expectExtent("SkyBox 4\n", {-2, -2, -2}, {2, 2, 2});
    expectExtent("FullScreen\n", {-1, -1, 0}, {1, 1, 0});
    expectExtent("Sphere -2 8 6\n", {-2, -2, -2}, {2, 2, 2});
}

TEST(Primitives, TheSeedOfAJitterCloudMatters) {
    const auto positions = [](std::string_view text) {
        return makeMesh(run(text), ShapeIndex(0))->attribute(geometry::kPosition)->values;
    };
    EXPECT_EQ(positions("JitterCloud 3 3 3\n"), positions("JitterCloud 3 3 3 0\n"));
    EXPECT_NE(positions("JitterCloud 3 3 3\n"), positions("JitterCloud 3 3 3 1\n"));
    EXPECT_EQ(positions("JitterCloud 3 3 3 -1\n"), positions("JitterCloud 3 3 3 4294967295\n"));
}

TEST(Primitives, AZeroSizeDrawsNothing) {
    for (const char* text :
         {"Box 1 0 1", "Sphere 0", "Cylinder 1 0", "Cone 0 1", "Torus 1 0", "Soccerball 0", "DiskXY 1 0",
          "QuadXY 1 0", "QuadXZ 1 0", "QuadYZ 1 0", "WireSphere 0", "WireTorus 0 1", "WireCylinder 0 1",
          "WireCone 1 0", "WireCube 0", "WireBox 1 1 0"}) {
        const Scene scene = run(std::string(text) + "\n");
        ASSERT_EQ(scene.shapes.size(), 1U) << text;
        EXPECT_TRUE(drawsNothing(scene.shapes.at(0))) << text;
        EXPECT_EQ(countsOf(scene.shapes.at(0))->vertices, 0U) << text;
        const auto mesh = makeMesh(scene, ShapeIndex(0));
        ASSERT_TRUE(mesh) << text;
        EXPECT_EQ(mesh->vertexCount(), 0U) << text;
        EXPECT_TRUE(mesh->indices.empty()) << text;
    }
    for (const char* text : {"QuadXY 0 1", "DiskXY 0 1", "Sphere", "QuadBox", "Teapot"})
        EXPECT_FALSE(drawsNothing(run(std::string(text) + "\n").shapes.at(0))) << text;
}

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

TEST(Models, ObjCommandsGiveTheirKindOfMesh) {
    const TemporaryFolder folder;
    folder.write("square.obj", kSquare);
    const Scene scene = run("Obj square.obj\nWireObj square.obj\nObjAdj square.obj\nObjPatch square.obj\n",
                            folder.path() / "a.glib");
    ASSERT_EQ(scene.shapes.size(), 4U);
    const std::array topologies{triangles, lines, trianglesAdjacency, patches};
    const std::array indices{6U, 8U, 12U, 6U};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto mesh = makeMesh(scene, ShapeIndex(i));
        ASSERT_TRUE(mesh);
        EXPECT_EQ(mesh->topology, topologies[i]);
        EXPECT_EQ(mesh->indices.size(), indices[i]);
        EXPECT_FALSE(countsOf(scene.shapes.at(i))) << "only the file knows";
        EXPECT_FALSE(drawsNothing(scene.shapes.at(i)));
    }
}

TEST(Models, TangentsAreMadeOnlyIfWanted) {
    const TemporaryFolder folder;
    folder.write("square.obj", kSquare);
    const Scene scene = run("Obj square.obj\n", folder.path() / "a.glib");
    EXPECT_NE(makeMesh(scene, ShapeIndex(0))->attribute(geometry::kTangent), nullptr);
    EXPECT_EQ(makeMesh(scene, ShapeIndex(0), false)->attribute(geometry::kTangent), nullptr);
}

TEST(Models, OnlyWireObjReadsLinesAndPoints) {
    const TemporaryFolder folder;
    folder.write("lines.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\np 3\n");
    const Scene scene = run("WireObj lines.obj\nObj lines.obj\nObjAdj lines.obj\nObjPatch lines.obj\n",
                            folder.path() / "a.glib");
    const auto wire = makeMesh(scene, ShapeIndex(0));
    ASSERT_TRUE(wire) << textsOf(wire.diagnostics);
    EXPECT_TRUE(wire.diagnostics.empty());
    EXPECT_EQ(wire->topology, lines);
    EXPECT_EQ(wire->indices.size(), 5U);
    EXPECT_EQ(wire->pointCount, 1U);
    for (std::size_t i = 1; i < 4; ++i) {
        const auto mesh = makeMesh(scene, ShapeIndex(i));
        EXPECT_FALSE(mesh);
        EXPECT_EQ(idsOf(mesh.diagnostics), "file-W04 file-W04 file-E07");
    }
}

TEST(Models, MessagesAboutTheFileComeWithTheMesh) {
    const TemporaryFolder folder;
    folder.write("square.obj", std::string(kSquare) + "l 1 2\n");
    const Scene scene = run("\nObj Square.obj\n", folder.path() / "a.glib");
    const auto mesh = makeMesh(scene, ShapeIndex(0));
    EXPECT_TRUE(mesh);
    EXPECT_EQ(idsOf(mesh.diagnostics), "file-W01 file-W04");
    EXPECT_EQ(mesh.diagnostics.at(0).place.line, 2);
    EXPECT_EQ(mesh.diagnostics.at(1).place.file, (folder.path() / "square.obj").generic_string());
}

TEST(Models, UnreadableModelsAreReportedAtTheSceneOrInTheFile) {
    const TemporaryFolder folder;
    folder.write("empty.obj", "");
    folder.write("faceless.obj", "v 0 0 0\n");
    folder.write("broken.shp", "no shapes");
    const Scene scene =
        run("Obj absent.obj\nObj empty.obj\nObj faceless.obj\nShp broken.shp\n", folder.path() / "a.glib");
    ASSERT_EQ(scene.shapes.size(), 4U);
    const std::array ids{"file-E01", "file-E02", "file-E07", "file-E04"};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto mesh = makeMesh(scene, ShapeIndex(i));
        EXPECT_FALSE(mesh);
        EXPECT_EQ(idsOf(mesh.diagnostics), ids[i]) << textsOf(mesh.diagnostics);
    }
    EXPECT_EQ(makeMesh(scene, ShapeIndex(0)).diagnostics.at(0).place.line, 1);
    EXPECT_EQ(makeMesh(scene, ShapeIndex(1)).diagnostics.at(0).place.line, 2);
}

TEST(Models, AShapefileIsReadByItsContent) {
    // One point (type 1) at (3, 4): header of 100 bytes, record header of 8, content of 20.
    std::string file(128, '\0');
    const auto big = [&](std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<char>(value >> (24 - 8 * i) & 0xffU);
    };
    const auto little = [&](std::size_t at, std::uint64_t value, std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i) file[at + i] = static_cast<char>(value >> 8 * i & 0xffU);
    };
    big(0, 9994);
    big(24, 64);
    little(28, 1000, 4);
    little(32, 1, 4);
    big(100, 1);
    big(104, 10);
    little(108, 1, 4);
    little(112, 0x4008000000000000U, 8);
    little(120, 0x4010000000000000U, 8);
    const TemporaryFolder folder;
    folder.write("point.shp", file);
    const auto mesh = makeMesh(run("Shp point.shp\n", folder.path() / "a.glib"), ShapeIndex(0));
    ASSERT_TRUE(mesh) << textsOf(mesh.diagnostics);
    EXPECT_EQ(mesh->topology, points);
    ASSERT_EQ(mesh->vertexCount(), 1U);
    EXPECT_EQ(mesh->attribute(geometry::kPosition)->values.at(0), 3);
    EXPECT_EQ(mesh->attribute(geometry::kPosition)->values.at(1), 4);
}

}  // namespace
}  // namespace glibra::scene
