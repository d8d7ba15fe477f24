// Programs, shapes and limits (language, 2.1, 3.3, 3.5 and 11).

#include <gtest/gtest.h>

#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

std::string stagesOf(const Scene& scene, const Program& program) {
    std::string text;
    for (const StageFile& each : program.stages)
        text += std::to_string(static_cast<int>(each.stage)) + scene.files[each.file].name + " ";
    return text;
}

TEST(Programs, StagesAreInheritedByTheNextProgram) {
    const Scene scene =
        run("Vertex a.vert\nFragment a.frag\nProgram One uA 1\nFragment b.frag\nProgram Two uB 2\n");
    ASSERT_EQ(scene.programs.size(), 2U);
    EXPECT_EQ(stagesOf(scene, scene.programs.at(0)), "0a.vert 4a.frag ");
    EXPECT_EQ(stagesOf(scene, scene.programs.at(1)), "0a.vert 4b.frag ");
    EXPECT_EQ(scene.files.size(), 3U);
    EXPECT_EQ(scene.programs.at(0).name, "One");
    EXPECT_EQ(scene.programs.at(1).place.line, 5);
    EXPECT_EQ(scene.programs.at(1).uniforms.at(0).tag, "uB");
}

TEST(Programs, AStageWordWithoutFileRemovesTheStage) {
    const Scene scene =
        run("Vertex a.vert\nTessControl a.tcs\nTessEvaluation a.tes\nGeometry a.geom\nFragment "
            "a.frag\nProgram A\n"
            "TessControl\nTessEvaluation\nGeometry\nProgram B\n");
    EXPECT_EQ(stagesOf(scene, scene.programs.at(0)), "0a.vert 1a.tcs 2a.tes 3a.geom 4a.frag ");
    EXPECT_EQ(stagesOf(scene, scene.programs.at(1)), "0a.vert 4a.frag ");
    EXPECT_FALSE(scene.programs.at(1).hasStage(glsl::Stage::geometry));
}

TEST(Programs, TheCommandDecidesTheStageNotTheSuffix) {
    const Scene scene = run("Vertex odd.frag\nProgram A\n");
    EXPECT_EQ(scene.programs.at(0).stages.at(0).stage, glsl::Stage::vertex);
}

TEST(Programs, DrawsUseTheProgramOfTheirPlace) {
    const auto draws = drawsOf(run("Sphere\nVertex a\nProgram A\nSphere\nProgram A\nSphere\n"));
    EXPECT_FALSE(draws.at(0).program);
    EXPECT_EQ(draws.at(1).program, ProgramIndex(0));
    EXPECT_EQ(draws.at(2).program, ProgramIndex(1)) << "the same files make another program";
}

TEST(Programs, GeometryTypesStayInForce) {
    const Scene scene =
        run("Program A\nGeometryInput gl_lines\nGeometryOutput triangles_strip\nGeometryVerticesOut "
            "12\nProgram B\nProgram C\n");
    EXPECT_EQ(scene.programs.at(0).geometryInput, "");
    EXPECT_EQ(scene.programs.at(0).geometryVerticesOut, 0);
    for (const std::size_t i : {1U, 2U}) {
        EXPECT_EQ(scene.programs.at(i).geometryInput, "lines");
        EXPECT_EQ(scene.programs.at(i).geometryOutput, "triangle_strip");
        EXPECT_EQ(scene.programs.at(i).geometryVerticesOut, 12);
    }
}

TEST(Programs, AMissingStageFileIsNotReportedBeforeItIsNeeded) {
    const Scene scene = run("Vertex no-such.vert\nProgram A\nSphere\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "");
    EXPECT_EQ(textsOf(scene.files.at(0).remarks), "1:8 file-E01 cannot find 'no-such.vert'");
    EXPECT_TRUE(scene.files.at(0).path.empty());
}

TEST(Programs, GstapHasNoEffect) {
    const Scene scene = run("GSTAP\ngstap.h\nSphere\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "");
    EXPECT_EQ(drawsOf(scene).size(), 1U);
}

TEST(Shapes, EqualPrimitivesShareOneShape) {
    const Scene scene =
        run("Sphere\nSphere 1\nSphere 1 60 60\nSphere 2\nWireSphere 1 60 60\nBox 2\nCube 2 2 2\n");
    const auto draws = drawsOf(scene);
    EXPECT_EQ(scene.shapes.size(), 4U);
    EXPECT_EQ(draws.at(0).shape, draws.at(2).shape);
    EXPECT_NE(draws.at(0).shape, draws.at(3).shape);
    EXPECT_NE(draws.at(2).shape, draws.at(4).shape);
    EXPECT_EQ(draws.at(5).shape, draws.at(6).shape);
    EXPECT_EQ(draws.at(6).word, "Cube");
}

TEST(Shapes, AModelUnderTwoSpellingsIsOneShape) {
    const TemporaryFolder folder;
    folder.write("cow.obj");
    const Scene scene = run("Obj cow.obj\nObj COW.OBJ\nObj ./cow.obj\n", folder.path() / "a.glib");
    EXPECT_EQ(scene.shapes.size(), 1U);
}

TEST(Shapes, MissingModelsWithDifferentNamesAreDifferentShapes) {
    EXPECT_EQ(run("Obj a.obj\nObj b.obj\n").shapes.size(), 2U);
}

TEST(Shapes, AModelNeedsAName) {
    const Scene scene = run("Obj\nShp\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "1:1 glib-E09 Obj needs a file name; only the interactive program works without one\n"
              "2:1 glib-E09 Shp needs a file name; only the interactive program works without one");
    EXPECT_TRUE(drawsOf(scene).empty());
}

TEST(Limits, AShapeWithTooManyVerticesIsNotDrawn) {
    const Scene scene = run("Sphere 1 9000 9000\nSphere\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "1:1 glib-E15 Sphere 1 9000 9000 needs 81,017,999 vertices; the limit is 8,388,608");
    EXPECT_EQ(drawsOf(scene).size(), 1U);
}

TEST(Limits, CountsWhoseProductPasses64BitsOfVerticesAreStillTooMany) {
    EXPECT_EQ(idsOf(run("PointCloud 65536 65536 65536\n").diagnostics), "glib-E15");
}

TEST(Limits, ASceneHas67108864VerticesAtMost) {
    std::string text;
    for (int i = 0; i < 32; ++i) text += "PointCloud 128 128 128\n";  // 2,097,152 each
    EXPECT_EQ(idsOf(run(text).diagnostics), "");
    const Scene scene = run(text + "PointCloud 1 1 1\nPointCloud 1 1 1\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E15 glib-E15");
    EXPECT_EQ(drawsOf(scene).size(), 32U);
    EXPECT_EQ(scene.diagnostics.at(0).text,
              "PointCloud 1 1 1 brings the scene to 67,108,865 vertices; the limit is 67,108,864");
}

TEST(Limits, AScriptMadeByHandCannotBreakAnything) {
    const int last =
        static_cast<int>(glib::CommandId::firstPrimitive) + static_cast<int>(geometry::primitives().size());
    for (int id = 0; id <= last; ++id) {
        glib::Script script;
        glib::Command command;
        command.id = static_cast<glib::CommandId>(id);
        command.word = "Word";
        script.commands.push_back(command);
        command.id = glib::CommandId::glBegin;
        command.values = {glib::wordOf("points", {})};
        script.commands.push_back(command);
        command.id = static_cast<glib::CommandId>(id);
        command.values.clear();
        script.commands.push_back(command);
        EXPECT_FALSE(interpret(script).frame.passes.empty()) << id;
    }
}

TEST(Programs, OneAfterEverythingThatIsDrawnIsNoted) {
    const auto messages = [](std::string_view text) { return textsOf(run(text).diagnostics); };
    const std::string camera = "LookAt 0 0 5 0 0 0 0 1 0\n";
    EXPECT_EQ(messages(camera + "Sphere\nProgram Lit\nColor 1 0 0\n"),
              "3:1 draw-N04 Program 'Lit' stands after everything that is drawn, so nothing uses it; move it "
              "before the shapes");
    EXPECT_EQ(idsOf(run(camera + "Program A\nSphere\nProgram B\nProgram C\n").diagnostics),
              "draw-N04 draw-N04");
    for (const char* each : {"Program A\nSphere\n", "Sphere\nProgram A\nObjAdj cow.obj\n",
                             "Sphere\nProgram A\nglBegin points\nglVertex 0 0 0\nglEnd\n", "Program A\n",
                             "Let late <false>\nSphere\nProgram A\nWhen (late)\nSphere\nEndWhen\n"})
        EXPECT_EQ(messages(camera + each).find("draw-N04"), std::string::npos) << each;
}

}  // namespace
}  // namespace glibra::scene
