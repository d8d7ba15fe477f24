// glBegin lists, Triangles and LinesAdjacency in the interpreter (language, 4.6 and 4.7).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::textsOf;

const geometry::Mesh& firstList(const Scene& scene) {
    return *scene.shapes.at(0).list;
}
std::vector<float> attributeValues(const geometry::Mesh& mesh, std::string_view name) {
    const geometry::Attribute* attribute = mesh.attribute(name);
    return attribute != nullptr ? attribute->values : std::vector<float>{};
}

constexpr const char* kTriangle =
    "glBegin triangles\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 0 1 0\nglEnd\n";

TEST(Lists, AListIsDrawnByItsEnd) {
    const Scene scene = run(kTriangle);
    const auto draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 1U);
    EXPECT_EQ(draws[0].word, "triangles");
    EXPECT_EQ(draws[0].place.line, 5);
    EXPECT_EQ(firstList(scene).topology, geometry::Topology::triangles);
    EXPECT_EQ(firstList(scene).vertexCount(), 3U);
    EXPECT_EQ(idsOf(scene.diagnostics), "");
}

TEST(Lists, EqualListsShareOneShape) {
    const Scene scene = run(std::string(kTriangle) + "Color 1 0 0\n" + kTriangle);
    EXPECT_EQ(scene.shapes.size(), 1U);
    const auto draws = drawsOf(scene);
    EXPECT_EQ(draws.at(0).color, glm::dvec4(1.0));
    EXPECT_EQ(draws.at(1).color, glm::dvec4(1, 0, 0, 1));
}

TEST(Lists, ListsThatDifferInOneNumberDoNotShare) {
    const Scene scene = run(std::string(kTriangle) +
                            "glBegin triangles\nglVertex 0 0 0\nglVertex 1 0 0\nglVertex 0 1 .5\nglEnd\n");
    EXPECT_EQ(scene.shapes.size(), 2U);
}

TEST(Lists, EveryVertexTakesTheColourOfItsPlace) {
    const Scene scene = run(
        "glBegin gl_triangles\nColor 1 0 0\nglVertex 0 0 0\nColor 0 1 0\nglVertex 1 0 0\nglColor 0 0 1 .5\n"
        "glVertex 0 1 0\nglEnd\nSphere\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "") << "Color belongs to a list";
    EXPECT_EQ(attributeValues(firstList(scene), geometry::kColor),
              (std::vector<float>{1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, .5F}));
    EXPECT_EQ(drawsOf(scene).at(1).color, glm::dvec4(0, 1, 0, 1)) << "glColor is no current colour";
}

TEST(Lists, ANewListBeginsWithTheCurrentColourAndNoAttributes) {
    const Scene scene =
        run("Color 1 1 0\nglBegin points\nglColor 0 0 1\nglTexCoord .5 .5\nglNormal 1 0 0\nglVertex 0 0 "
            "0\nglEnd\n"
            "glBegin points\nglVertex 0 0 0\nglEnd\n");
    const auto draws = drawsOf(scene);
    EXPECT_EQ(draws.at(0).color, glm::dvec4(0, 0, 1, 1));
    EXPECT_EQ(draws.at(1).color, glm::dvec4(1, 1, 0, 1));
    const geometry::Mesh& second = *scene.shapes.at(1).list;
    EXPECT_EQ(attributeValues(second, geometry::kNormal), (std::vector<float>{0, 0, 1}));
    EXPECT_EQ(second.attribute(geometry::kTexCoord), nullptr);
}

TEST(Lists, NormalsAndTexCoordsBelongToTheFollowingVertices) {
    const Scene scene =
        run("glBegin lines\nglNormal 0 1 0\nglTexCoord .25 .5 .75\nglVertex 0 0 0\nglTexCoord 1 0 0 "
            "2\nglVertex 1 0 0 2\nglEnd\n");
    EXPECT_EQ(attributeValues(firstList(scene), geometry::kNormal), (std::vector<float>{0, 1, 0, 0, 1, 0}));
    EXPECT_EQ(attributeValues(firstList(scene), geometry::kTexCoord),
              (std::vector<float>{.25F, .5F, .75F, 1, 1, 0, 0, 2}));
    EXPECT_EQ(attributeValues(firstList(scene), geometry::kPosition),
              (std::vector<float>{0, 0, 0, 1, 1, 0, 0, 2}));
}

TEST(Lists, OtherCommandsInsideAreExecutedBeforeTheList) {
    const Scene scene =
        run("glBegin points\nglVertex 0 0 0\nObj cow.obj\nTranslate 1 0 0\nglVertex 1 1 1\nglEnd\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "3:1 glib-W32 Obj is inside glBegin ... glEnd; it is drawn before the list\n"
              "4:1 glib-W32 Translate is inside glBegin ... glEnd; it takes effect before the list");
    const auto draws = drawsOf(scene);
    ASSERT_EQ(draws.size(), 2U);
    EXPECT_EQ(draws[0].word, "Obj");
    EXPECT_EQ(draws[0].modelView, glm::dmat4(1.0));
    EXPECT_EQ(draws[1].modelView[3][0], 1);
    EXPECT_EQ(scene.shapes.at(1).list->vertexCount(), 2U);
}

TEST(Lists, ProgramTargetAndSecondBeginAreRefusedInside) {
    const Scene scene = run(
        "Texture2D 6 8 8\nglBegin points\nglVertex 0 0 0\nProgram A uB 1\nRenderToTexture 6\nglBegin lines\n"
        "glVertex 1 1 1\nglEnd\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "4:1 glib-E07 Program is not allowed inside glBegin ... glEnd\n"
              "5:1 glib-E07 RenderToTexture is not allowed inside glBegin ... glEnd\n"
              "6:1 glib-E07 glBegin is not allowed inside glBegin ... glEnd");
    EXPECT_TRUE(scene.programs.empty());
    EXPECT_EQ(firstList(scene).vertexCount(), 2U) << "the first list goes on";
}

TEST(Lists, ConsecutiveVerticesOutsideAListAreReportedOnce) {
    const Scene scene = run("glVertex 0 0 0\nglVertex 0 0 0\nglEnd\nSphere\nglEnd\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "1:1 glib-E07 glVertex outside glBegin ... glEnd\n"
              "5:1 glib-E07 glEnd outside glBegin ... glEnd");
}

TEST(Lists, AMissingEndIsReportedAtTheBegin) {
    const Scene scene = run("Sphere\nglBegin points\nglVertex 0 0 0\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "2:1 glib-E07 glBegin without glEnd");
    EXPECT_EQ(drawsOf(scene).size(), 1U);
}

TEST(Lists, AnIncompleteLastPrimitiveIsIgnored) {
    const Scene scene =
        run("NumPatchVertices 4\nglBegin patches\nglVertex 0 0 0\nglVertex 0 0 0\nglVertex 0 0 0\nglVertex 0 "
            "0 0\n"
            "glVertex 0 0 0\nglVertex 0 0 0\nglEnd\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "9:1 glib-W33 glEnd: 2 vertices of an incomplete patch ignored");
    EXPECT_EQ(firstList(scene).patchVertices, 4);
    EXPECT_EQ(firstList(scene).indices.size(), 4U);
}

TEST(Lists, NoCompletePrimitiveIsAnError) {
    const Scene scene =
        run("glBegin triangles\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\nglBegin points\nglEnd\n");
    EXPECT_EQ(textsOf(scene.diagnostics),
              "4:1 glib-E07 glEnd: 2 vertices are not enough for one triangle\n"
              "6:1 glib-E07 glEnd: 0 vertices are not enough for one point");
    EXPECT_TRUE(drawsOf(scene).empty());
}

TEST(Lists, ThePatchSizeIsThatOfTheEnd) {
    const Scene scene = run("glBegin patches\nglVertex 0 0 0\nglVertex 0 0 0\nNumPatchVertices 2\nglEnd\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-W32");
    EXPECT_EQ(firstList(scene).patchVertices, 2);
}

TEST(Lists, TrianglesAndLinesWithAdjacencyAreMeshesToo) {
    const Scene scene = run("Triangles [0 0 0] [1 0 0] [0 1 0 2]\nLinesAdjacency 0 0 0 1 0 0 2 0 0 3 0 0\n");
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(scene.shapes.at(0).list->topology, geometry::Topology::triangles);
    EXPECT_EQ(attributeValues(*scene.shapes.at(0).list, geometry::kPosition),
              (std::vector<float>{0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 2}));
    EXPECT_EQ(scene.shapes.at(1).list->topology, geometry::Topology::linesAdjacency);
    EXPECT_EQ(scene.shapes.at(1).list->indices.size(), 4U);
    EXPECT_EQ(drawsOf(scene).at(0).word, "Triangles");
}

TEST(Lists, AListHolds1048576Vertices) {
    // A scene cannot have that many statements, so the script is made by hand.
    glib::Script script;
    script.path = "big.glib";
    glib::Command command;
    command.id = glib::CommandId::glBegin;
    command.word = "glBegin";
    command.values = {glib::wordOf("points", {})};
    script.commands.push_back(command);
    command.id = glib::CommandId::glVertex;
    command.word = "glVertex";
    command.values.clear();
    command.numbers = {0, 0, 0};
    for (int i = 0; i < 1'048'577; ++i) script.commands.push_back(command);
    const Scene scene = interpret(script);
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E15 glib-E07");
    script.commands.pop_back();
    command.id = glib::CommandId::glEnd;
    script.commands.push_back(command);
    EXPECT_EQ(idsOf(interpret(script).diagnostics), "");
}

}  // namespace
}  // namespace glibra::scene
