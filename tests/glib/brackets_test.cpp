// Brackets (language, 1.6), and the point groups of LinesAdjacency and Triangles.

#include <gtest/gtest.h>

#include "scene.h"

namespace glibra::glib::test {
namespace {

/// The values of the only tag of a Program, and its form.
UniformSpec onlyTag(std::string_view text) {
    const Script script = read(text);
    if (script.commands.size() != 1 || script.commands[0].uniforms.size() != 1) return {};
    return script.commands[0].uniforms[0];
}

TEST(Brackets, AroundPlainArgumentsAreIgnoredWithOneWarning) {
    EXPECT_EQ(numbersOf("Color [1 .5 0]"), (Numbers{1, .5, 0, 1}));
    EXPECT_EQ(idsOf("Color [1 .5 0]"), Ids{"glib-W10"});
    EXPECT_EQ(idsOf("Background {1. 1. 1.}"), Ids{"glib-W10"});
    EXPECT_EQ(idsOf("Translate <1> (2) [3]"), Ids{"glib-W10"});
    EXPECT_EQ(textOf("Obj [cow.obj]"), "cow.obj");
}

TEST(Brackets, WrongClosingBracketClosesTheGroup) {
    EXPECT_EQ(onlyTag("Program P uA <0. 0. .5)").values, (Numbers{0, 0, .5}));
    EXPECT_EQ(onlyTag("Program P uA <0. 0. .5)").form, UniformForm::range);
    EXPECT_EQ(idsOf("Program P uA <0. 0. .5)"), Ids{"glib-W08"});
    EXPECT_EQ(idsOf("Color [1 .5 0>"), (Ids{"glib-W10", "glib-W08"}));
}

TEST(Brackets, UnclosedGroupEndsBeforeTheNextWord) {
    EXPECT_EQ(tagsOf("Program P uA <0 1 2 uKd 3"), (Words{"uA", "uKd"}));
    EXPECT_EQ(idsOf("Program P uA <0 1 2 uKd 3"), Ids{"glib-W09"});
    EXPECT_EQ(idsOf("Program P uA <0 1 2 _x 3"), Ids{"glib-W09"});
}

TEST(Brackets, UnclosedGroupEndsWithTheStatement) {
    EXPECT_EQ(onlyTag("Program P uA <0 1 2").values, (Numbers{0, 1, 2}));
    EXPECT_EQ(idsOf("Program P uA <0 1 2"), Ids{"glib-W09"});
    EXPECT_EQ(idsOf("Color [1 .5 0"), (Ids{"glib-W10", "glib-W09"}));
}

TEST(Brackets, UnclosedGroupEndsBeforeAnotherBracket) {
    EXPECT_EQ(idsOf("LinesAdjacency [0 0 0 [1 1 1] [2 2 2] [3 3 3]"), Ids{"glib-W09"});
    EXPECT_EQ(read("LinesAdjacency [0 0 0 [1 1 1] [2 2 2] [3 3 3]").commands.at(0).numbers.size(), 16U);
}

TEST(Brackets, OtherTokensInAGroupAreValues) {
    EXPECT_EQ(onlyTag("Program P uA <0 ? 2>").values, (Numbers{0, 0, 2}));
    EXPECT_EQ(idsOf("Program P uA <0 ? 2>"), Ids{"glib-W05"});
}

TEST(Brackets, RoundOnesAreReadAsSquareOnes) {
    EXPECT_EQ(onlyTag("Program P uA (1 2 3)").form, UniformForm::list);
    EXPECT_EQ(onlyTag("Program P uA (1 2 3)").values, (Numbers{1, 2, 3}));
    EXPECT_EQ(idsOf("Program P uA (1 2 3)"), Ids{"glib-W10"});
}

TEST(Brackets, BraceBlockAfterAProgramNameIsRefusedOnce) {
    const char* scene = "Program Lighting {\n  vertex a.vert\n  uKa { 1 0 0 }\n}\nTeapot";
    EXPECT_EQ(idsOf(scene), Ids{"glib-E10"});
    EXPECT_EQ(placeOf(scene, "glib-E10"), "1:1");
    EXPECT_EQ(wordsOf(scene), Words{"Teapot"});
}

TEST(Brackets, BraceBlockThatIsNeverClosedHidesNothing) {
    EXPECT_EQ(idsOf("Program Lighting { # x\nSpere\nTeapot"), (Ids{"glib-E10", "glib-E01"}));
    EXPECT_EQ(wordsOf("Program Lighting {\nTeapot"), Words{"Teapot"});
}

TEST(Brackets, ColourOfAProgramIsNoBraceBlock) {
    EXPECT_TRUE(idsOf("Program P uC {1 0 0}").empty());
    EXPECT_TRUE(idsOf("Program P uC { \\\n 1 0 0 }").empty());
}

TEST(Points, GroupsInBrackets) {
    const Script script = read("LinesAdjacency [0. 0. 0.] [1. 1. 1.] [2. 1. 2.] [3. -1. 0.]");
    ASSERT_EQ(script.commands.size(), 1U);
    EXPECT_EQ(script.commands[0].numbers, (Numbers{0, 0, 0, 1, 1, 1, 1, 1, 2, 1, 2, 1, 3, -1, 0, 1}));
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(Points, WithoutBracketsNumbersAreTakenByThrees) {
    const Script script = read("Triangles 0 0 0  1 0 0  0 1 0");
    EXPECT_EQ(script.commands.at(0).numbers, (Numbers{0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1}));
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(Points, GroupMayHoldFourNumbers) {
    const Script script = read("Triangles [0 0 0 1] [1 0 0 2] [0 1 0]");
    EXPECT_EQ(script.commands.at(0).numbers, (Numbers{0, 0, 0, 1, 1, 0, 0, 2, 0, 1, 0, 1}));
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(Points, SurplusNumbersOfAGroupAreIgnored) {
    EXPECT_EQ(idsOf("Triangles [0 0 0 1 5 6] [1 0 0] [0 1 0]"), Ids{"glib-W07"});
    EXPECT_EQ(read("Triangles [0 0 0 1 5 6] [1 0 0] [0 1 0]").commands.at(0).numbers.size(), 12U);
}

TEST(Points, OtherBracketsAreReadAsSquareOnes) {
    EXPECT_EQ(idsOf("Triangles (0 0 0) [1 0 0] [0 1 0]"), Ids{"glib-W10"});
    EXPECT_EQ(idsOf("Triangles [0 0 0) [1 0 0] [0 1 0]"), Ids{"glib-W08"});
}

TEST(Points, WrongCountsAreRefused) {
    EXPECT_EQ(idsOf("Triangles [0 0 0] [1 0 0]"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("Triangles"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("LinesAdjacency [0 0 0] [1 0 0] [0 1 0]"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("Triangles [0 0] [1 0 0] [0 1 0]"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("Triangles [] [1 0 0] [0 1 0]"), Ids{"glib-E04"});
    EXPECT_EQ(idsOf("Triangles 0 0 0 1 0 0 0 1"), Ids{"glib-E04"});
    EXPECT_TRUE(read("Triangles [0 0] [1 0 0] [0 1 0]").commands.empty());
}

}  // namespace
}  // namespace glibra::glib::test
