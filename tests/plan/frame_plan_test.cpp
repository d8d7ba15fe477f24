// The content of a plan: its diagnostics, programs, and the textures of draws.
#include "plan/frame_plan.h"

#include <gtest/gtest.h>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using glsl::Stage;
using test::drawn;
using test::ids;
using test::interfaceWith;
using test::number;
using test::Programs;
using test::SceneByHand;
using test::textOf;

const PlannedDraw& firstDraw(const FramePlan& plan) {
    for (const PlannedPass& pass : plan.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<PlannedDraw>(&step)) return *draw;
    throw std::logic_error("nothing is drawn");
}

TEST(BuiltinProgram, DrawsSilentlyWithoutAProgram) {
    SceneByHand hand;
    Programs programs;
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), "Sphere");
    EXPECT_EQ(programs.askedPrograms(), std::vector{scene::ProgramIndex()});
    EXPECT_TRUE(plan.diagnostics.empty());
}
TEST(BuiltinProgram, ReplacesAnIncompleteProgramAndIsReportedOnce) {
    SceneByHand hand;
    Programs programs;
    hand.program("Dots", {Stage::geometry, Stage::fragment});
    hand.scene.programs.back().uniforms.push_back(number("uUnknown", 1));
    hand.sphere();
    const Place first = hand.sphere().place;
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(programs.askedPrograms(), std::vector{scene::ProgramIndex()});
    EXPECT_EQ(ids(plan.diagnostics), "draw-W01");
    EXPECT_EQ(plan.diagnostics[0].text, "Program 'Dots' has no vertex stage; a flat colour is used");
    EXPECT_EQ(plan.diagnostics[0].place.line, first.line - 1);
}
TEST(BuiltinProgram, IsReportedWithTheMissingStages) {
    SceneByHand hand;
    Programs programs;
    hand.program("B", {});
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    ASSERT_EQ(plan.diagnostics.size(), 1U);
    EXPECT_EQ(plan.diagnostics[0].text,
              "Program 'B' has no vertex and no fragment stage; a flat colour is used");
}
TEST(BuiltinProgram, IsNotUsedForAProgramWithOneEndOfThePipeline) {
    for (const Stage stage : {Stage::vertex, Stage::fragment}) {
        SceneByHand hand;
        Programs programs;
        const auto program = hand.program("A", {stage});
        programs.byIndex[program] = interfaceWith({});
        hand.sphere();
        programs.plan(hand.scene);
        EXPECT_EQ(programs.askedPrograms(), std::vector{program});
    }
}

TEST(PlannedTexture, IsWhatTheSlotHoldsAtEachDraw) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms.push_back(number("uTex", 6));
    programs.byIndex[program] = interfaceWith({{"uTex", "sampler2D"}});
    const auto first = hand.texture(6);
    hand.sphere();
    const auto second = hand.texture(6);
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(std::get<PlannedDraw>(plan.passes[0].steps[0]).textures.at(0).view.texture, first);
    EXPECT_EQ(std::get<PlannedDraw>(plan.passes[0].steps[1]).textures.at(0).view.texture, second);
    EXPECT_EQ(plan.textures, (std::vector{first, second}));
    EXPECT_EQ(plan.programs.size(), 1U);
}
TEST(PlannedTexture, InAnEmptySlotIsReportedOncePerProgram) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms.push_back(number("uTexUnit", 5));
    programs.byIndex[program] = interfaceWith({{"uTexUnit", "sampler3D"}});
    hand.texture(5);
    hand.sphere();
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(textOf(plan.diagnostics, "draw-W02"), "sampler 'uTexUnit' reads unit 5 / 3D, which is empty");
    EXPECT_FALSE(firstDraw(plan).textures.at(0).view.texture);
}

struct Feedback : testing::Test {
    SceneByHand hand;
    Programs programs;
    scene::TextureIndex target = hand.emptyTexture(6);
    int passLine = 0;

    FramePlan plan(const char* word) {
        const auto program = hand.program("Dots");
        hand.scene.programs.back().uniforms.push_back(number("uTex", 6));
        programs.byIndex[program] = interfaceWith({{"uTex", word}});
        passLine = hand.target({target}).place.line;
        hand.draw("QuadXY", hand.shape(glib::commandOf("QuadXY")));
        hand.window();
        hand.sphere();
        return programs.plan(hand.scene);
    }
};
TEST_F(Feedback, OfASamplerIsAnError) {
    const FramePlan result = plan("sampler2D");
    EXPECT_EQ(textOf(result.diagnostics, "draw-E01"),
              "QuadXY samples unit 6 while rendering into it (RenderToTexture on line " +
                  std::to_string(passLine) + ")");
    EXPECT_EQ(drawn(result), " | | Sphere");
}
TEST_F(Feedback, DoesNotConcernAnotherTargetOfTheUnit) {
    hand.texture(6, scene::TextureTarget::cube);
    programs.imageWriters.emplace_back(0U);
    EXPECT_EQ(ids(plan("samplerCube").diagnostics), "");
}

TEST_F(Feedback, DoesNotConcernImages) {
    programs.imageWriters.emplace_back(0U);
    EXPECT_EQ(ids(plan("image2D").diagnostics), "");
}

TEST(VertexInput, ThatIsUnknownIsReported) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    programs.byIndex[program] = interfaceWith({});
    programs.byIndex[program].inputs = {{"aVertex", 0},       {"glibra_Normal", 1},  {"aPos", 2},
                                        {"glibra_sample", 3}, {"gl_InstanceID", -1}, {"glibra_unnamed", 4}};
    programs.byIndex[program].facts.userNames["glibra_sample"] = "sample";
    hand.sphere();
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    const Diagnostics found = test::withId(plan.diagnostics, "draw-W03");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].text, "vertex input 'aPos' is not supplied; it reads 0 0 0 1");
    EXPECT_EQ(found[1].text, "vertex input 'sample' is not supplied; it reads 0 0 0 1");
}

TEST(PointSizeMode, ZeroIgnoresWhatTheProgramWrites) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("points");
    programs.byIndex[program] = interfaceWith({});
    programs.byIndex[program].facts.writesPointSize = true;
    hand.sphere();
    hand.draw("PointCloud", hand.shape(glib::commandOf("PointCloud")));
    EXPECT_EQ(textOf(programs.plan(hand.scene).diagnostics, "draw-W05"),
              "points.vert writes gl_PointSize, but PointSizeMode is 0");
}

TEST(MeshesWithAdjacency, AreMadeBesideThePlainOnes) {
    SceneByHand hand;
    Programs programs;
    const auto plain = hand.program("plain");
    programs.byIndex[plain] = interfaceWith({});
    const auto outline = hand.program("outline", {Stage::vertex, Stage::geometry, Stage::fragment});
    programs.byIndex[outline] = interfaceWith({});
    programs.byIndex[outline].facts.geometryInput = "triangles_adjacency";
    const scene::ShapeIndex sphere = hand.shape(glib::commandOf("Sphere"));
    const scene::ShapeIndex model = hand.shape(glib::CommandId::objAdj);
    for (const auto program : {plain, outline, plain, outline}) {
        hand.currentProgram = program;
        hand.draw("Sphere", sphere);
        hand.draw("ObjAdj", model);
    }
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(ids(plan.diagnostics), "");
    ASSERT_EQ(plan.meshes.size(), 3U) << "two of the sphere, one of the model";
    std::vector<std::size_t> meshes;
    for (const auto& step : plan.passes.at(0).steps)
        meshes.push_back(std::get<PlannedDraw>(step).mesh.position());
    EXPECT_EQ(meshes, (std::vector<std::size_t>{0, 1, 2, 1, 0, 1, 2, 1}));
    EXPECT_FALSE(plan.meshes.at(0).adjacency);
    EXPECT_FALSE(plan.meshes.at(1).adjacency) << "the model has its own";
    EXPECT_EQ(plan.meshes.at(2).adjacency, geometry::Topology::trianglesAdjacency);
    EXPECT_EQ(plan.meshes.at(2).attributes, plan.meshes.at(0).attributes);
}

TEST(WrongSubmission, LeavesTheDrawOutAndKeepsTheRest) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("silh", {Stage::vertex, Stage::geometry, Stage::fragment});
    programs.byIndex[program] = interfaceWith({});
    programs.byIndex[program].facts.geometryInput = "triangles";
    hand.draw("PointCloud", hand.shape(glib::commandOf("PointCloud")));
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(ids(plan.diagnostics), "draw-E02");
    EXPECT_EQ(drawn(plan), "Sphere");
}

TEST(TooManyUnits, AreAnErrorOfTheDraw) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms = {number("a", 5), number("b", 6)};
    programs.byIndex[program] = interfaceWith({{"a", "sampler2D"}, {"b", "sampler2D"}});
    hand.sphere();
    PlanOptions options;
    options.maxTextureUnits = 1;
    const FramePlan plan = programs.plan(hand.scene, options);
    EXPECT_EQ(textOf(plan.diagnostics, "draw-E13"),
              "Sphere: the program needs 2 texture units at once; the graphics device has 1");
    EXPECT_EQ(drawn(plan), "");
}

TEST(UnusableProgram, ReportsItsErrorsOnceAndKeepsItsDraws) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms.push_back(number("uKa", 1));
    programs.byIndex[program].facts.diagnostics = {
        diagnose("glsl-E01", "'vMC' : undeclared identifier", {"a.frag", 3, 1}),
        diagnose("glsl-W01", "no #version", {"a.frag", 1, 1})};
    hand.sphere();
    hand.sphere().flatColors = true;  // a second variant with the same messages
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(plan.programs.size(), 2U);
    EXPECT_EQ(ids(plan.diagnostics), "glsl-E01 glsl-W01");
    EXPECT_EQ(drawn(plan), "Sphere Sphere");
    EXPECT_EQ(plan.meshes.at(0).attributes, std::vector<std::string>{"position"});
}

TEST(UniformsOfAPlan, AreResolvedAndReportedOnceForAllVariants) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms = {number("uKa", .5), number("ukb", 1)};
    programs.byIndex[program] = interfaceWith({{"uKa", "float"}});
    hand.sphere();
    hand.sphere().flatColors = true;
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(ids(plan.diagnostics), "glib-W23");
    for (const PlannedProgram& each : plan.programs) ASSERT_EQ(each.values.size(), 1U);
}

TEST(OverridesOfAPlan, ThatNameNothingAreReportedOnceWithoutAPlace) {
    SceneByHand hand;
    Programs programs;
    for (const char* name : {"A", "B"}) {
        const auto program = hand.program(name);
        programs.byIndex[program] = interfaceWith({{"uShrink", "float"}});
        hand.sphere();
    }
    PlanOptions options;
    options.overrides = {{"uShrink", glib::UniformForm::number, {.5}},
                         {"ushrink", glib::UniformForm::number, {1}}};
    const FramePlan plan = programs.plan(hand.scene, options);
    EXPECT_EQ(ids(plan.diagnostics), "glib-W23");
    EXPECT_EQ(plan.diagnostics[0].text,
              "no program of the scene has a uniform 'ushrink'; did you mean 'uShrink'?");
    EXPECT_TRUE(plan.diagnostics[0].place.file.empty());
}
TEST(OverridesOfAPlan, ThatAreDeclaredButInactiveHaveTheirOwnMessage) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("A");
    programs.byIndex[program] = interfaceWith({});
    programs.byIndex[program].facts.uniforms["uUnused"] = {};
    hand.sphere();
    PlanOptions options;
    options.overrides = {{"uUnused", glib::UniformForm::number, {1}},
                         {"uUnused", glib::UniformForm::number, {1}, "B"}};
    const FramePlan plan = programs.plan(hand.scene, options);
    EXPECT_EQ(ids(plan.diagnostics), "glib-W24 glib-W23");
    EXPECT_EQ(plan.diagnostics[0].text,
              "uniform 'uUnused' is declared but unused, so setting it has no effect");
    EXPECT_EQ(plan.diagnostics[1].text, "no program 'B' has a uniform 'uUnused'");
}
TEST(OverridesOfAPlan, OfAProgramThatWasNotNeededAreAccepted) {
    SceneByHand hand;
    Programs programs;
    hand.program("Unused");
    hand.scene.programs.back().uniforms.push_back(number("uKd", 1));
    const auto program = hand.program("Dots");
    programs.byIndex[program] = interfaceWith({});
    hand.sphere();
    PlanOptions options;
    options.overrides = {{"uKd", glib::UniformForm::number, {.5}}};
    EXPECT_EQ(ids(programs.plan(hand.scene, options).diagnostics), "");
}

std::string summary(const FramePlan& plan) {
    std::string text = drawn(plan) + "\n";
    for (const Diagnostic& each : plan.diagnostics) text += toString(each) + "\n";
    for (const Skipped& each : plan.skipped) text += each.what + " " + each.why + "\n";
    for (const PlannedProgram& each : plan.programs)
        text += std::to_string(each.variant.program.position()) + " ";
    for (const scene::TextureIndex each : plan.textures) text += std::to_string(each.position()) + " ";
    for (const PlannedMesh& mesh : plan.meshes)
        for (const std::string& attribute : mesh.attributes) text += attribute + " ";
    return text;
}
TEST(Planning, TwiceGivesTheSamePlan) {
    SceneByHand hand;
    Programs programs;
    hand.noise(2);
    const auto target = hand.emptyTexture(10);
    const auto program = hand.program("Dots");
    hand.scene.programs.back().uniforms = {number("uTex", 10), number("uWrong", 1), number("uOther", 2)};
    programs.byIndex[program] = interfaceWith({{"uTex", "sampler2D"}, {"uB", "float"}, {"uC", "float"}});
    const auto maker = hand.program("Maker");
    programs.byIndex[maker] = interfaceWith({{"Noise2", "sampler2D"}});
    hand.target({target});
    hand.teapot();
    hand.currentProgram = program;
    hand.window();
    hand.sphere();
    const std::string first = summary(programs.plan(hand.scene));
    EXPECT_EQ(summary(programs.plan(hand.scene)), first);
    EXPECT_NE(first.find("glib-W37"), std::string::npos);
}

}  // namespace
}  // namespace glibra::plan
