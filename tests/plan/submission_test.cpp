// Primitives and shader stages: the table of language, 4.8.
#include "plan/submission.h"

#include <gtest/gtest.h>

#include "by_hand.h"
#include "scene/primitives.h"

namespace glibra::plan {
namespace {

using geometry::Topology;
using glib::CommandId;
using glsl::Stage;
using test::SceneByHand;

constexpr std::initializer_list<Stage> kPlain{Stage::vertex, Stage::fragment};
constexpr std::initializer_list<Stage> kTessellated{Stage::vertex, Stage::tessControl, Stage::tessEvaluation,
                                                    Stage::fragment};
constexpr std::initializer_list<Stage> kGeometry{Stage::vertex, Stage::geometry, Stage::fragment};
constexpr std::initializer_list<Stage> kEverything{Stage::vertex, Stage::tessControl, Stage::tessEvaluation,
                                                   Stage::geometry, Stage::fragment};

struct Case {
    SceneByHand hand;
    ProgramInterface interface;

    explicit Case(std::initializer_list<Stage> stages) { hand.program("silh", stages); }
    Result<Submission> submit(const char* word, scene::ShapeIndex shape, int patchVertices = 3) {
        scene::Draw& draw = hand.draw(word, shape);
        draw.patchVertices = patchVertices;
        return submissionOf(hand.scene, draw, &hand.scene.programs.at(0), interface);
    }
    Result<Submission> submit(const char* word, CommandId command, int patchVertices = 3) {
        return submit(word, hand.shape(command), patchVertices);
    }
};

void expectSubmission(const Result<Submission>& result, Topology topology, int patchVertices) {
    ASSERT_TRUE(result);
    EXPECT_EQ(result->topology, topology);
    EXPECT_EQ(result->patchVertices, patchVertices);
}
void expectError(const Result<Submission>& result, const char* id, const char* text) {
    EXPECT_FALSE(result);
    ASSERT_EQ(result.diagnostics.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].id, id);
    EXPECT_EQ(result.diagnostics[0].text, text);
    EXPECT_EQ(result.diagnostics[0].severity, Severity::error);
    EXPECT_GT(result.diagnostics[0].place.line, 1);
}

TEST(Submitting, WithoutTessellationIsTheShapesOwnKind) {
    expectSubmission(Case(kPlain).submit("Sphere", glib::commandOf("Sphere")), Topology::triangles, 0);
    expectSubmission(Case(kPlain).submit("ObjAdj", CommandId::objAdj), Topology::trianglesAdjacency, 0);
    expectSubmission(Case(kPlain).submit("PointCloud", glib::commandOf("PointCloud")), Topology::points, 0);
}
TEST(Submitting, PatchesWithoutAnEvaluationStageFails) {
    Case one(kPlain);
    expectError(one.submit("glBegin", one.hand.list(Topology::patches, 4)), "draw-E04",
                "gl_patches needs a TessEvaluation stage");
    expectError(one.submit("ObjPatch", CommandId::objPatch), "draw-E04",
                "ObjPatch needs a TessEvaluation stage");
}
TEST(Submitting, PatchesWithTheBuiltinProgramFails) {
    SceneByHand hand;
    const scene::Draw draw = hand.draw("ObjPatch", hand.shape(CommandId::objPatch));
    expectError(submissionOf(hand.scene, draw, nullptr, {}), "draw-E04",
                "ObjPatch needs a TessEvaluation stage");
}

TEST(Tessellating, TrianglesNeedsAPatchSizeOfThree) {
    expectSubmission(Case(kTessellated).submit("Teapot", glib::commandOf("Teapot"), 3), Topology::patches, 3);
    expectError(Case(kTessellated).submit("Teapot", glib::commandOf("Teapot"), 16), "draw-E03",
                "Teapot delivers triangles, but the patch size is 16; write 'NumPatchVertices 3'");
}
TEST(Tessellating, TrianglesIsAllowedByAControlStageOfThreeVertices) {
    Case one(kTessellated);
    one.interface.facts.patchVertices = 3;
    expectSubmission(one.submit("Teapot", glib::commandOf("Teapot"), 16), Topology::patches, 3);
}
TEST(Tessellating, LinesIsNotAllowedByAControlStage) {
    Case one(kTessellated);
    one.interface.facts.patchVertices = 2;
    EXPECT_EQ(one.submit("WireSphere", glib::commandOf("WireSphere"), 3).diagnostics.at(0).id, "draw-E03");
}
TEST(Tessellating, OtherKindsNeedTheirOwnPatchSize) {
    const std::vector<std::pair<CommandId, int>> kinds{{glib::commandOf("WireSphere"), 2},
                                                       {glib::commandOf("PointCloud"), 1},
                                                       {CommandId::objAdj, 6},
                                                       {CommandId::linesAdjacency, 4}};
    for (const auto& [command, vertices] : kinds) {
        expectSubmission(Case(kTessellated).submit("X", command, vertices), Topology::patches, vertices);
        EXPECT_EQ(Case(kTessellated).submit("X", command, 3).diagnostics.at(0).id, "draw-E03");
    }
    expectError(Case(kTessellated).submit("WireSphere", glib::commandOf("WireSphere"), 3), "draw-E03",
                "WireSphere delivers lines, but the patch size is 3; write 'NumPatchVertices 2'");
}
TEST(Tessellating, PatchesStayAsTheyAre) {
    Case one(kTessellated);
    expectSubmission(one.submit("glBegin", one.hand.list(Topology::patches, 16), 3), Topology::patches, 16);
    expectSubmission(one.submit("ObjPatch", CommandId::objPatch, 16), Topology::patches, 3);
}

TEST(GeometryStage, TakesItsOwnKind) {
    Case one(kGeometry);
    one.interface.facts.geometryInput = "triangles";
    expectSubmission(one.submit("Sphere", glib::commandOf("Sphere")), Topology::triangles, 0);
    expectSubmission(one.submit("glBegin", one.hand.list(Topology::triangles)), Topology::triangles, 0);
}
TEST(GeometryStage, ThatWantsAdjacencyGetsItFromTriangles) {
    for (const auto& [word, topology] : {std::pair{"triangles_adjacency", Topology::trianglesAdjacency},
                                         std::pair{"lines_adjacency", Topology::linesAdjacency}}) {
        Case one(kGeometry);
        one.interface.facts.geometryInput = word;
        expectSubmission(one.submit("Obj", CommandId::obj), topology, 0);
        expectSubmission(one.submit("Torus", glib::commandOf("Torus")), topology, 0);
        expectSubmission(one.submit("glBegin", one.hand.list(Topology::triangles)), topology, 0);
    }
}
TEST(GeometryStage, ThatWantsAdjacencyTakesItsOwnKind) {
    Case one(kGeometry);
    one.interface.facts.geometryInput = "triangles_adjacency";
    expectSubmission(one.submit("ObjAdj", CommandId::objAdj), Topology::trianglesAdjacency, 0);
    one.interface.facts.geometryInput = "lines_adjacency";
    expectSubmission(one.submit("LinesAdjacency", CommandId::linesAdjacency), Topology::linesAdjacency, 0);
}
TEST(GeometryStage, ThatWantsAdjacencyRecommendsTheSolidOfAWire) {
    Case one(kGeometry);
    one.interface.facts.geometryInput = "triangles_adjacency";
    expectError(one.submit("WireSphere", glib::commandOf("WireSphere")), "draw-E02",
                "WireSphere delivers lines, but silh.geom expects triangles_adjacency; use Sphere");
    expectError(one.submit("WireObj", CommandId::wireObj), "draw-E02",
                "WireObj delivers lines, but silh.geom expects triangles_adjacency; use Obj");
    expectError(one.submit("PointCloud", glib::commandOf("PointCloud")), "draw-E02",
                "PointCloud delivers points, but silh.geom expects triangles_adjacency");
    one.interface.facts.geometryInput = "lines_adjacency";
    expectError(one.submit("WireSphere", glib::commandOf("WireSphere")), "draw-E02",
                "WireSphere delivers lines, but silh.geom expects lines_adjacency; use LinesAdjacency");
}
TEST(GeometryStage, AfterTessellationGetsNoAdjacency) {
    Case one(kEverything);
    one.interface.facts.geometryInput = "triangles_adjacency";
    one.interface.facts.tessellationOutput = "triangles";
    expectError(one.submit("Teapot", glib::commandOf("Teapot")), "draw-E02",
                "Teapot delivers triangles after tessellation, but silh.geom expects triangles_adjacency");
}
TEST(GeometryStage, ThatWantsLinesRecommendsTheWireForm) {
    Case one(kGeometry);
    one.interface.facts.geometryInput = "lines";
    expectError(one.submit("Sphere", glib::commandOf("Sphere")), "draw-E02",
                "Sphere delivers triangles, but silh.geom expects lines; use WireSphere");
    expectError(one.submit("Soccerball", glib::commandOf("Soccerball")), "draw-E02",
                "Soccerball delivers triangles, but silh.geom expects lines");
}
TEST(GeometryStage, ThatWantsTrianglesRefusesAdjacency) {
    Case one(kGeometry);
    one.interface.facts.geometryInput = "triangles";
    expectError(one.submit("ObjAdj", CommandId::objAdj), "draw-E02",
                "ObjAdj delivers triangles_adjacency, but silh.geom expects triangles; use Obj");
}
TEST(GeometryStage, AfterTessellationTakesWhatThatDelivers) {
    Case one(kEverything);
    one.interface.facts.geometryInput = "triangles";
    one.interface.facts.tessellationOutput = "triangles";
    expectSubmission(one.submit("Teapot", glib::commandOf("Teapot")), Topology::patches, 3);
    one.interface.facts.tessellationOutput = "lines";
    expectError(one.submit("Teapot", glib::commandOf("Teapot")), "draw-E02",
                "Teapot delivers lines after tessellation, but silh.geom expects triangles");
}

struct PointSizeCase : Case {
    using Case::Case;
    bool ignores(CommandId command, bool mode = false) {
        interface.facts.writesPointSize = true;
        scene::Draw& draw = hand.draw("X", hand.shape(command));
        draw.raster.change().pointSizeFromShader = mode;
        return ignoresPointSize(draw, &hand.scene.programs.at(0), interface,
                                {topologyOf(hand.scene.shapes.back()), 0});
    }
};
TEST(PointSize, OfPointsIsIgnoredInModeZeroOnly) {
    EXPECT_TRUE(PointSizeCase(kPlain).ignores(glib::commandOf("PointCloud")));
    EXPECT_FALSE(PointSizeCase(kPlain).ignores(glib::commandOf("PointCloud"), true));
}
TEST(PointSize, DoesNotMatterForTriangles) {
    EXPECT_FALSE(PointSizeCase(kPlain).ignores(glib::commandOf("Sphere")));
}
TEST(PointSize, MattersAfterAStageThatDeliversPoints) {
    PointSizeCase tessellated(kTessellated);
    tessellated.interface.facts.tessellationOutput = "points";
    EXPECT_TRUE(tessellated.ignores(glib::commandOf("Sphere")));
    PointSizeCase geometry(kGeometry);
    geometry.interface.facts.geometryOutput = "triangle_strip";
    EXPECT_FALSE(geometry.ignores(glib::commandOf("PointCloud")));
    geometry.interface.facts.geometryOutput = "points";
    EXPECT_TRUE(geometry.ignores(glib::commandOf("Sphere")));
}

}  // namespace
}  // namespace glibra::plan
