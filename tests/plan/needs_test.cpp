// The skip rules: a plan requests, makes and draws only what the picture needs, and says why it skips the
// rest.
#include "plan/needs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using test::drawn;
using test::interfaceWith;
using test::number;
using test::Programs;
using test::SceneByHand;
using test::skipped;
using Words = std::vector<std::string>;

/// Adds a program of two stages that samples one unit, and makes it current.
scene::ProgramIndex sampling(SceneByHand& hand, Programs& programs, const std::string& name, int unit) {
    const auto program = hand.program(name);
    hand.scene.programs.back().uniforms.push_back(number("uTexUnit", unit));
    programs.byIndex[program] = interfaceWith({{"uTexUnit", "sampler2D"}});
    return program;
}
scene::ProgramIndex plain(SceneByHand& hand, Programs& programs, const std::string& name) {
    const auto program = hand.program(name);
    programs.byIndex[program] = interfaceWith({});
    return program;
}

/// The same with an image of the unit that the program writes.
scene::ProgramIndex writing(SceneByHand& hand, Programs& programs, const std::string& name, int unit) {
    const auto program = hand.program(name);
    hand.scene.programs.back().uniforms.push_back(number("uImage", unit));
    programs.byIndex[program] = interfaceWith({{"uImage", "image2D"}});
    programs.imageWriters.push_back(program);
    return program;
}

TEST(Needs, AProgramWithoutDrawsIsNotRequested) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Unused");
    const auto used = plain(hand, programs, "Used");
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(programs.askedPrograms(), std::vector{used});
    EXPECT_EQ(skipped(plan, "program"), Words{"'Unused': nothing is drawn with it"});
    EXPECT_EQ(skipped(plan, "file"), (Words{"'shaders/Unused.vert': nothing visible needs it",
                                            "'shaders/Unused.frag': nothing visible needs it"}));
}

TEST(Needs, AProgramIsRequestedOncePerVariant) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Dots");
    hand.sphere();
    hand.sphere();
    hand.sphere().flatColors = true;
    hand.teapot();
    const FramePlan plan = programs.plan(hand.scene);
    ASSERT_EQ(programs.asked.size(), 2U);
    EXPECT_EQ(programs.asked[1], (ProgramVariant{scene::ProgramIndex(0), true, 1}));
    EXPECT_EQ(plan.meshes.size(), 2U);
}

TEST(Needs, DrawsBeforeTheLastClearOfTheWindowAreSkipped) {
    SceneByHand hand;
    Programs programs;
    const auto hidden = plain(hand, programs, "Hidden");
    hand.teapot();
    hand.clear();
    hand.teapot();
    hand.clear();
    const auto clearLine = hand.line;
    plain(hand, programs, "Seen");
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), "Clear Sphere");
    const std::string why = "the window is cleared again on line " + std::to_string(clearLine);
    EXPECT_EQ(skipped(plan, "draw"), (Words{"Teapot: " + why, "Teapot: " + why}));
    EXPECT_EQ(skipped(plan, "statement"), Words{"Clear: " + why});
    EXPECT_EQ(skipped(plan, "mesh"), Words{"Teapot: nothing visible draws it"});
    EXPECT_EQ(skipped(plan, "program"), Words{"'Hidden': nothing visible is drawn with it"});
    EXPECT_TRUE(std::ranges::all_of(programs.askedForImages, [&](auto each) { return each == hidden; }));
}

TEST(Needs, DrawsBeforeAClearAreKeptForWritesOfImagesThatAreRead) {
    for (const bool isRead : {true, false}) {
        SceneByHand hand;
        Programs programs;
        hand.emptyTexture(10);
        plain(hand, programs, "Depth");
        hand.teapot();
        writing(hand, programs, "Writer", 10);
        hand.sphere();
        plain(hand, programs, "Hidden");
        hand.teapot();
        hand.clear();
        isRead ? sampling(hand, programs, "Seen", 10) : plain(hand, programs, "Seen");
        hand.sphere();
        EXPECT_EQ(drawn(programs.plan(hand.scene)), isRead ? "Teapot Sphere Clear Sphere" : "Clear Sphere");
    }
}

TEST(Needs, APassOfTheWindowBeforeTheLastClearIsSkipped) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Dots");
    hand.sphere();
    const auto target = hand.emptyTexture(6);
    hand.target({target});
    hand.teapot();
    hand.window();
    hand.clear();
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), "Clear Sphere");
    EXPECT_EQ(skipped(plan, "pass").size(), 2U);
}

TEST(Needs, AWindowWithoutDrawsIsStillCleared) {
    const SceneByHand hand;
    Programs programs;
    const FramePlan plan = programs.plan(hand.scene);
    ASSERT_EQ(plan.passes.size(), 1U);
    EXPECT_TRUE(plan.passes[0].steps.empty());
}

// A is sampled by B, B by the window, and C by nothing.
TEST(Needs, PassesFollowAChainOfSampledTargets) {
    SceneByHand hand;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    const auto b = hand.emptyTexture(11);
    const auto c = hand.emptyTexture(12);
    const auto first = plain(hand, programs, "A");
    hand.target({a});
    hand.sphere();
    const auto second = sampling(hand, programs, "B", 10);
    hand.target({b});
    hand.teapot();
    plain(hand, programs, "C");
    hand.target({c});
    hand.draw("Torus", hand.shape(glib::commandOf("Torus")));
    const auto last = sampling(hand, programs, "Final", 11);
    hand.window();
    hand.draw("QuadXY", hand.shape(glib::commandOf("QuadXY")));
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), " | Sphere | Teapot | QuadXY");
    EXPECT_EQ(programs.askedPrograms(), (std::vector{last, second, first}));
    EXPECT_EQ(plan.textures, (std::vector{a, b}));
    EXPECT_EQ(skipped(plan, "pass"), Words{"nothing visible samples its targets"});
    EXPECT_EQ(skipped(plan, "texture"), Words{"unit 12 / 2D: no active sampler reads it"});
    EXPECT_EQ(skipped(plan, "program"), Words{"'C': nothing visible is drawn with it"});
    EXPECT_TRUE(plan.diagnostics.empty());
}

// The target is sampled before this frame draws into it, so its content comes from the previous frame.
TEST(Needs, APassIsNeededEvenIfItsTargetIsReadEarlierInTheFrame) {
    SceneByHand hand;
    hand.scene.goesOn = true;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    sampling(hand, programs, "Reader", 10);
    hand.sphere();
    plain(hand, programs, "Writer");
    hand.target({a});
    hand.teapot();
    EXPECT_EQ(drawn(programs.plan(hand.scene)), "Sphere | Teapot");
}

TEST(Needs, TheSearchEndsAtTwoPassesThatFeedEachOther) {
    SceneByHand hand;
    hand.scene.goesOn = true;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    const auto b = hand.emptyTexture(11);
    sampling(hand, programs, "ReadsB", 11);
    hand.target({a});
    hand.sphere();
    sampling(hand, programs, "ReadsA", 10);
    hand.target({b});
    hand.teapot();
    hand.window();
    hand.sphere();
    EXPECT_EQ(drawn(programs.plan(hand.scene)), " | Sphere | Teapot | Sphere");
}

TEST(Needs, AllTargetsOfANeededPassExistButOnlyTargetsThatAreReadNeedOtherPasses) {
    SceneByHand hand;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    const auto b = hand.emptyTexture(11);
    plain(hand, programs, "Both");
    hand.target({a, b});
    hand.sphere();
    plain(hand, programs, "OnlyB");
    hand.target({b});
    hand.teapot();
    sampling(hand, programs, "Final", 10);
    hand.window();
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), " | Sphere | Sphere");
    EXPECT_EQ(plan.textures, (std::vector{a, b}));
    EXPECT_EQ(plan.programs.at(1).variant.colorTargets, 2);
}

TEST(Needs, APassThatSharesDepthNeedsThePassBeforeIt) {
    SceneByHand hand;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    plain(hand, programs, "Dots");
    hand.target({a});
    hand.sphere();
    const auto again = hand.emptyTexture(10);  // the same unit, so the same depth buffer
    scene::Pass& second = hand.target({again});
    second.depthBuffer = hand.depthBufferOf(a);
    second.clearDepth = false;
    hand.teapot();
    sampling(hand, programs, "Final", 10);
    hand.window();
    hand.sphere();
    EXPECT_EQ(drawn(programs.plan(hand.scene)), " | Sphere | Teapot | Sphere");
}

TEST(Needs, APassThatClearsItsSharedDepthNeedsNoPassBeforeIt) {
    SceneByHand hand;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    plain(hand, programs, "Dots");
    hand.target({a});
    hand.sphere();
    const auto again = hand.emptyTexture(10);
    scene::Pass& second = hand.target({again});
    second.depthBuffer = hand.depthBufferOf(a);
    second.clearDepth = false;
    hand.clear();
    hand.teapot();
    sampling(hand, programs, "Final", 10);
    hand.window();
    hand.sphere();
    EXPECT_EQ(drawn(programs.plan(hand.scene)), " | Clear Teapot | Sphere");
}

TEST(Needs, APassThatWritesAnImageIsNeededAndSoIsWhatItSamples) {
    SceneByHand hand;
    Programs programs;
    const auto a = hand.emptyTexture(10);
    const auto b = hand.emptyTexture(11);
    hand.emptyTexture(9);
    plain(hand, programs, "Source");
    hand.target({a});
    hand.sphere();
    const auto writer = writing(hand, programs, "Writer", 9);
    hand.scene.programs[writer].uniforms.push_back(number("uTexUnit", 10));
    programs.byIndex[writer] = interfaceWith({{"uImage", "image2D"}, {"uTexUnit", "sampler2D"}});
    hand.target({b});
    hand.teapot();
    sampling(hand, programs, "Final", 9);
    hand.window();
    hand.sphere();
    EXPECT_EQ(drawn(programs.plan(hand.scene)), " | Sphere | Teapot | Sphere");
}

TEST(Needs, ImageWritesDoNotMatterIfEverythingIsVisible) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Dots");
    hand.sphere();
    programs.plan(hand.scene);
    EXPECT_TRUE(programs.askedForImages.empty());
}

TEST(Needs, ADrawOfSizeZeroIsSkippedWithItsProgram) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Dots");
    hand.draw("Sphere", hand.shape(glib::commandOf("Sphere"), {0, 60, 60}));
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(drawn(plan), "");
    EXPECT_TRUE(programs.asked.empty());
    EXPECT_EQ(skipped(plan, "draw"), Words{"Sphere: it has no size and draws nothing"});
}

TEST(Needs, ATextureThatIsNeverSampledIsSkippedWithItsFile) {
    SceneByHand hand;
    Programs programs;
    const auto used = hand.texture(5);
    hand.texture(6);
    sampling(hand, programs, "Dots", 5);
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(plan.textures, std::vector{used});
    EXPECT_EQ(skipped(plan, "texture"), Words{"unit 6 / 2D: no active sampler reads it"});
    EXPECT_EQ(skipped(plan, "file"), Words{"'picture6.png': nothing visible needs it"});
}

TEST(Needs, NoiseIsMadeOnlyIfAnActiveSamplerReadsIt) {
    SceneByHand hand;
    Programs programs;
    hand.noise(2);
    const auto noise3 = hand.noise(3);
    const auto program = hand.program("Dots");
    programs.byIndex[program] = interfaceWith({{"Noise3", "sampler3D"}});
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    EXPECT_EQ(plan.textures, std::vector{noise3});
    EXPECT_EQ(skipped(plan, "noise texture"), Words{"unit 2 / 2D: no active sampler reads it"});
}

TEST(Needs, NoiseIsMadeForAnySamplerThatReadsItsSlot) {
    SceneByHand hand;
    Programs programs;
    const auto noise2 = hand.noise(2);
    sampling(hand, programs, "Dots", 2);
    hand.sphere();
    EXPECT_EQ(programs.plan(hand.scene).textures, std::vector{noise2});
}

TEST(Needs, AttributesThatNoProgramReadsAreNotMade) {
    SceneByHand hand;
    Programs programs;
    const auto program = hand.program("Dots");
    programs.byIndex[program] = interfaceWith({});
    programs.byIndex[program].inputs = {{"aVertex", 0}, {"glibra_Normal", 1}, {"gl_VertexID", -1}};
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    ASSERT_EQ(plan.meshes.size(), 1U);
    EXPECT_EQ(plan.meshes.at(0).attributes, (Words{"position", "normal"}));
    EXPECT_EQ(skipped(plan, "attribute"),
              (Words{"texCoord of Sphere: no program reads it", "tangent of Sphere: no program reads it"}));
}

TEST(Needs, AMeshHasTheAttributesOfAllProgramsThatDrawIt) {
    SceneByHand hand;
    Programs programs;
    plain(hand, programs, "Position");
    hand.sphere();
    const auto program = plain(hand, programs, "Tangents");
    programs.byIndex[program].inputs.push_back({"Tangent", 1});
    hand.sphere();
    const FramePlan plan = programs.plan(hand.scene);
    ASSERT_EQ(plan.meshes.size(), 1U);
    EXPECT_EQ(plan.meshes.at(0).attributes, (Words{"position", "tangent"}));
}

/// Reports shapes of that command as out of sight, and counts the calls.
struct Blinkers {
    glib::CommandId unseen{};
    int asked = 0;
    auto outOfSight(const scene::Scene& scene) {
        return [this, &scene](const scene::Draw& draw, const scene::Pass&) {
            ++asked;
            const bool isUnseen = scene.shapes[draw.shape].command == unseen;
            return isUnseen ? std::string("it is behind a wall") : std::string();
        };
    }
};

TEST(Needs, ADrawOutOfSightNeedsNoProgramMeshTextureOrPass) {
    SceneByHand hand;
    Programs programs;
    const auto target = hand.emptyTexture(6);
    plain(hand, programs, "Inner");
    hand.target({target});
    hand.sphere();
    hand.window();
    sampling(hand, programs, "Outer", 6);
    hand.teapot();
    hand.currentProgram = {};
    hand.sphere();
    Blinkers blinkers{glib::commandOf("Teapot")};
    const FramePlan plan = programs.plan(hand.scene, {}, blinkers.outOfSight(hand.scene));
    EXPECT_EQ(drawn(plan), " | Sphere");
    EXPECT_EQ(programs.askedPrograms(), std::vector{scene::ProgramIndex()});
    EXPECT_TRUE(plan.textures.empty());
    EXPECT_EQ(plan.meshes.size(), 1U);
    EXPECT_EQ(skipped(plan, "draw"), Words{"Teapot: it is behind a wall"});
    EXPECT_EQ(skipped(plan, "pass"), Words{"nothing visible samples its targets"});
    EXPECT_EQ(blinkers.asked, 2) << "nobody asks of a draw that is not needed anyway";
}

TEST(Needs, OutOfSightIsNotAskedIfEverythingIsWanted) {
    SceneByHand hand;
    Programs programs;
    hand.teapot();
    Blinkers blinkers{glib::commandOf("Teapot")};
    PlanOptions options;
    options.everything = true;
    EXPECT_EQ(drawn(programs.plan(hand.scene, options, blinkers.outOfSight(hand.scene))), "Teapot");
    EXPECT_EQ(blinkers.asked, 0);
}

TEST(Needs, OneMeshPerDrawIsPlannedOnlyOnRequest) {
    SceneByHand hand;
    Programs programs;
    for (int i = 0; i < 3; ++i) hand.sphere();
    EXPECT_EQ(programs.plan(hand.scene).meshes.size(), 1U);
    PlanOptions options;
    options.shareMeshes = false;
    const FramePlan plan = programs.plan(hand.scene, options);
    ASSERT_EQ(plan.meshes.size(), 3U);
    EXPECT_EQ(plan.meshes.at(1).attributes, plan.meshes.at(0).attributes);
}

TEST(Needs, CheckSkipsNothing) {
    SceneByHand hand;
    Programs programs;
    hand.noise(2);
    const auto c = hand.emptyTexture(12);
    plain(hand, programs, "Unused");
    plain(hand, programs, "Dots");
    hand.teapot();
    hand.clear();
    hand.draw("Sphere", hand.shape(glib::commandOf("Sphere"), {0, 60, 60}));
    hand.target({c});
    hand.sphere();
    PlanOptions options;
    options.everything = true;
    const FramePlan plan = programs.plan(hand.scene, options);
    EXPECT_EQ(drawn(plan), "Teapot Clear Sphere | Sphere");
    EXPECT_EQ(plan.textures.size(), 2U);
    EXPECT_TRUE(plan.skipped.empty());
    const auto asked = programs.askedPrograms();
    EXPECT_NE(std::find(asked.begin(), asked.end(), scene::ProgramIndex(0)), asked.end());
}

}  // namespace
}  // namespace glibra::plan
