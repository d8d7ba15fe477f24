// Statements and continuation (language, 1.3).

#include <gtest/gtest.h>

#include "scene.h"

namespace glibra::glib::test {
namespace {

TEST(Continuation, BackslashJoinsTheNextLine) {
    EXPECT_EQ(numbersOf("Sphere 2 \\\n  10 \\\n 20"), (std::vector<double>{2, 10, 20}));
    EXPECT_EQ(numbersOf("Sphere 2\\\n10 20"), (std::vector<double>{2, 10, 20}));
    EXPECT_TRUE(idsOf("Program P uX 1\\\n uY <0 1 2>\\\n uZ 3").empty());
    EXPECT_EQ(tagsOf("Program P uX 1\\\n uY <0 1 2>\\\n uZ 3"), (Words{"uX", "uY", "uZ"}));
}

TEST(Continuation, BackslashDirectlyBeforeACommentIsTheLastOfTheCode) {
    EXPECT_TRUE(idsOf("Program P \\# why\n uX 1").empty());
    EXPECT_EQ(tagsOf("Program P \\# why\n uX 1"), Words{"uX"});
}

TEST(Continuation, BlanksAndCommentsAfterTheBackslashAreReported) {
    EXPECT_EQ(idsOf("Program P \\  \n uX 1"), Ids{"glib-W02"});
    EXPECT_EQ(idsOf("Program P \\ # why\n uX 1"), Ids{"glib-W02"});
    EXPECT_EQ(tagsOf("Program P \\ \t// why\n uX 1"), Words{"uX"});
    EXPECT_EQ(placeOf("Program P \\  \n uX 1", "glib-W02"), "1:11");
}

TEST(Continuation, BackslashBeforeABlankLineIsVoid) {
    EXPECT_EQ(idsOf("Program P uX 1 \\\n\nTeapot"), Ids{"glib-W12"});
    EXPECT_EQ(placeOf("Program P uX 1 \\\n\nTeapot", "glib-W12"), "1:16");
    EXPECT_EQ(wordsOf("Program P uX 1 \\\n\nTeapot"), (Words{"Program", "Teapot"}));
}

TEST(Continuation, BackslashBeforeACommentLineIsVoid) {
    EXPECT_EQ(idsOf("Sphere 1 \\\n# x\nTeapot"), Ids{"glib-W12"});
}

TEST(Continuation, BackslashAtTheEndOfTheFileIsVoid) {
    EXPECT_EQ(idsOf("Sphere 1 \\"), Ids{"glib-W12"});
    EXPECT_EQ(idsOf("Sphere 1 \\\n"), Ids{"glib-W12"});
    EXPECT_EQ(wordsOf("Sphere 1 \\\n"), Words{"Sphere"});
}

TEST(Continuation, TagsAfterAVoidBackslashStillBelongToTheProgram) {
    EXPECT_EQ(idsOf("Program P uX 1 \\\n\n uY 2"), (Ids{"glib-W12", "glib-W11"}));
    EXPECT_EQ(tagsOf("Program P uX 1 \\\n\n uY 2"), (Words{"uX", "uY"}));
}

TEST(Continuation, CommandAfterAVoidBackslashIsACommandEvenIfItCouldBeATag) {
    EXPECT_EQ(wordsOf("Program P uX 1 \\\n\nScale 2"), (Words{"Program", "Scale"}));
}

TEST(Continuation, VoidBackslashEndsOtherStatements) {
    EXPECT_EQ(idsOf("Sphere 1 \\\n\n 20 20"), (Ids{"glib-W12", "glib-E01"}));
}

TEST(Continuation, LineOfABackslashAloneGoesOn) {
    EXPECT_TRUE(idsOf("Program P \\\n \\\n uX 1").empty());
    EXPECT_EQ(tagsOf("Program P \\\n \\\n uX 1"), Words{"uX"});
    EXPECT_EQ(wordsOf("\\\nTeapot"), Words{"Teapot"});
}

TEST(Tags, CommandWordAfterABackslashIsATagIfItHasAValue) {
    EXPECT_EQ(tagsOf("Program P \\\n Color {1 .5 0} \\\n Flat <false> \\\n Scale 2 \\\n Timer [1 2] uX 1"),
              (Words{"Color", "Flat", "Scale", "Timer", "uX"}));
    EXPECT_TRUE(idsOf("Program P \\\n Color {1 .5 0} \\\n Flat <false> \\\n Scale 2").empty());
}

TEST(Tags, CommandWordOnTheProgramsOwnLineIsATag) {
    EXPECT_EQ(tagsOf("Program P Scale 2 Color {1 0 0}"), (Words{"Scale", "Color"}));
}

TEST(Tags, CommandWordWithoutAPossibleValueStartsANewCommand) {
    EXPECT_EQ(wordsOf("Program P uX 1 \\\nObj cow.obj"), (Words{"Program", "Obj"}));
    EXPECT_EQ(idsOf("Program P uX 1 \\\nObj cow.obj"), Ids{"glib-W13"});
    EXPECT_EQ(placeOf("Program P uX 1 \\\nObj cow.obj", "glib-W13"), "2:1");
    EXPECT_EQ(idsOf("Program P uX 1 \\\nTeapot"), Ids{"glib-W13"});
    EXPECT_EQ(idsOf("Program P uX 1 \\\nTeapot \\\n\n"), (Ids{"glib-W13", "glib-W12"}));
    EXPECT_EQ(idsOf("Program P uX 1 \\\nColor 1. .5 0."), Ids{"glib-W13"});
    EXPECT_EQ(wordsOf("Program P uX 1 \\\nColor {1 0 0} {0 1 0}").back(), "Color");
}

TEST(Tags, MessageBoxAfterABackslashFollowsTheSameRule) {
    EXPECT_EQ(idsOf("Program P uX 1 \\\nMessageBox hello # 5"), Ids{"glib-W13"});
    EXPECT_EQ(tagsOf("Program P uX 1 \\\nMessageBox 5 # comment"), (Words{"uX", "MessageBox"}));
}

TEST(Tags, ProgramNameMayStandOnTheNextLineEvenIfItIsACommandWord) {
    EXPECT_EQ(textOf("Program \\\n Texture uTexUnit 6"), "Texture");
}

TEST(Tags, UnknownWordAfterABackslashIsATag) {
    EXPECT_EQ(tagsOf("Program P \\\n Spere 1"), Words{"Spere"});
}

TEST(Tags, ValueAfterABackslashBelongsToTheTagBefore) {
    const Script script = read("Program P uX \\\n <0 1 2>");
    ASSERT_EQ(script.commands.at(0).uniforms.size(), 1U);
    EXPECT_EQ(script.commands[0].uniforms[0].values, (std::vector<double>{0, 1, 2}));
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(WithoutBackslash, CommandWordStartsANewStatement) {
    EXPECT_EQ(wordsOf("Program P uX 1\nScale 2"), (Words{"Program", "Scale"}));
    EXPECT_TRUE(idsOf("Program P uX 1\nScale 2").empty());
}

TEST(WithoutBackslash, TagValuePairsContinueTheProgram) {
    EXPECT_EQ(idsOf("Program Magic uX 1\n  uY <0 1 2>\n\n# c\n  uZ {1 0 0} uFlag <true>"),
              (Ids{"glib-W11", "glib-W11"}));
    EXPECT_EQ(tagsOf("Program Magic uX 1\n  uY <0 1 2>\n\n# c\n  uZ {1 0 0} uFlag <true>"),
              (Words{"uX", "uY", "uZ", "uFlag"}));
}

TEST(WithoutBackslash, LaterTagsOfTheLineMayLackAValue) {
    EXPECT_EQ(idsOf("Program P\n uX 1 uY uZ 2"), (Ids{"glib-W11", "glib-W17"}));
}

TEST(WithoutBackslash, LineThatIsNoListOfPairsIsAnUnknownCommand) {
    EXPECT_EQ(idsOf("Program P uX 1\nSpere 1 60 60"), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Program P uX 1\nuY"), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Program P uX 1\n<0 1 2>"), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Program P uX 1\nuY image.bmp"), Ids{"glib-E01"});
}

TEST(WithoutBackslash, OtherStatementsEndWithTheLine) {
    EXPECT_EQ(idsOf("Sphere 1\n20 20"), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Teapot\nuX 1"), Ids{"glib-E01"});
}

TEST(OtherStatements, CommandWordAfterABackslashStartsANewStatement) {
    EXPECT_EQ(wordsOf("Sphere 1 \\\nTeapot"), (Words{"Sphere", "Teapot"}));
    EXPECT_EQ(idsOf("Sphere 1 \\\nTeapot"), Ids{"glib-W13"});
    EXPECT_EQ(idsOf("Sphere 1 \\\nScale 2"), Ids{"glib-W13"});
}

TEST(OtherStatements, OtherLinesAfterABackslashAreJoined) {
    EXPECT_EQ(numbersOf("LookAt 0 0 5 \\\n 0 0 0 \\\n 0 1 0"),
              (std::vector<double>{0, 0, 5, 0, 0, 0, 0, 1, 0}));
}

TEST(CubeMap, MissingFilesAreTakenFromTheNextLines) {
    const char* scene = "CubeMap 6 px.bmp nx.bmp\n  py.bmp ny.bmp\n\n pz.bmp nz.bmp\nTeapot";
    const Script script = read(scene);
    ASSERT_EQ(script.commands.size(), 2U);
    EXPECT_EQ(textsOf(script.commands[0]),
              (Words{"px.bmp", "nx.bmp", "py.bmp", "ny.bmp", "pz.bmp", "nz.bmp"}));
    EXPECT_EQ(idsOf(script), (Ids{"glib-W11", "glib-W11"}));
}

TEST(CubeMap, CommandWordEndsIt) {
    EXPECT_EQ(idsOf("CubeMap 6 px.bmp nx.bmp\nTeapot"), Ids{"glib-E04"});
    EXPECT_EQ(wordsOf("CubeMap 6 px.bmp nx.bmp\nTeapot"), Words{"Teapot"});
}

TEST(CubeMap, SixFilesEndIt) {
    EXPECT_EQ(idsOf("CubeMap 6 a b c d e f\ng"), Ids{"glib-E01"});
}

TEST(ByteRange, CoversTheStatementWithoutCommentsAndBackslash) {
    const std::string text =
        "# c\n  Program P \\ # x\n uX <0 1 2>\\\n\n  Sphere 2   // y\nMessageBox  a b  \n";
    const Script script = read(text);
    ASSERT_EQ(script.commands.size(), 3U);
    const auto slice = [&](const Command& c) { return text.substr(c.begin, c.end - c.begin); };
    EXPECT_EQ(slice(script.commands[0]), "Program P \\ # x\n uX <0 1 2>");
    EXPECT_EQ(slice(script.commands[1]), "Sphere 2");
    EXPECT_EQ(slice(script.commands[2]), "MessageBox  a b");
}

TEST(Positions, AreThoseOfWordNameTagAndValue) {
    const Script script = read("\n  Program  P uX 1 \\\n   uY  <0 1 2>");
    const Command& program = script.commands.at(0);
    EXPECT_EQ(program.position.line, 2);
    EXPECT_EQ(program.position.column, 3);
    EXPECT_EQ(program.textPosition().column, 12);
    EXPECT_EQ(program.uniforms.at(1).tagPosition.line, 3);
    EXPECT_EQ(program.uniforms[1].tagPosition.column, 4);
    EXPECT_EQ(program.uniforms[1].valuePosition.column, 8);
}

}  // namespace
}  // namespace glibra::glib::test
