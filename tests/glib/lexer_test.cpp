// Characters and lines, comments, tokens (language, 1.1, 1.2, 1.4).

#include <gtest/gtest.h>

#include <string>

#include "glib/statement_table.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

TEST(Characters, EmptyFileIsALegalScene) {
    const Script script = read("");
    EXPECT_TRUE(script.commands.empty());
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(Characters, ByteOrderMarkIsSkippedAndCountsNoColumn) {
    EXPECT_EQ(wordsOf("\xef\xbb\xbfTeapot\n"), Words{"Teapot"});
    EXPECT_EQ(placeOf("\xef\xbb\xbfSpere\n", "glib-E01"), "1:1");
}

TEST(Characters, ByteOrderMarkCountsInByteRanges) {
    const std::string text = "\xef\xbb\xbfSphere 2";
    const Script script = read(text);
    ASSERT_EQ(script.commands.size(), 1U);
    EXPECT_EQ(text.substr(script.commands[0].begin, script.commands[0].end - script.commands[0].begin),
              "Sphere 2");
}

TEST(Characters, ByteOrderMarkInsideIsAWord) {
    EXPECT_EQ(idsOf("\n\xef\xbb\xbfTeapot"), Ids{"glib-E01"});
}

TEST(Characters, ControlByteIsRefusedWithItsPlace) {
    EXPECT_EQ(idsOf(std::string("Teapot\nBox\0\n", 12)), Ids{"glib-E03"});
    EXPECT_EQ(placeOf(std::string("Teapot\nBox\0\n", 12), "glib-E03"), "2:4");
    EXPECT_EQ(idsOf("Teapot\x1a"), Ids{"glib-E03"});
    EXPECT_EQ(idsOf("# \x7f"), Ids{"glib-E03"});
}

TEST(Characters, ControlByteOnlyCostsItsOwnStatement) {
    EXPECT_EQ(wordsOf("Teapot\nBox\x01\nSphere\n"), (Words{"Teapot", "Sphere"}));
}

TEST(Characters, AllBlanksSeparateInSilence) {
    EXPECT_EQ(numbersOf("\tSphere \v 2\f\t10   20 \t"), (Numbers{2, 10, 20}));
    EXPECT_TRUE(idsOf("\tSphere \v 2\f\t10   20 \t").empty());
}

TEST(Characters, LineEndsMayBeMixed) {
    EXPECT_EQ(wordsOf("Teapot\nBox\r\nSphere\rCone"), (Words{"Teapot", "Box", "Sphere", "Cone"}));
    EXPECT_EQ(placeOf("Teapot\nBox\r\nSphere\rSpere", "glib-E01"), "4:1");
}

TEST(Characters, CrLfIsOneLineEndAfterABackslash) {
    EXPECT_EQ(numbersOf("Sphere 2 \\\r\n10 20\r\n"), (Numbers{2, 10, 20}));
    EXPECT_TRUE(idsOf("Sphere 2 \\\r\n10 20\r\n").empty());
}

TEST(Characters, NoBreakSpaceIsABlank) {
    EXPECT_EQ(numbersOf("Sphere\xc2\xa0"
                        "2\xc2\xa0"
                        "10"),
              (Numbers{2, 10, 60}));
    EXPECT_EQ(idsOf("Sphere\xc2\xa0"
                    "2\xc2\xa0"
                    "10"),
              Ids{"glib-W35"});
    EXPECT_EQ(placeOf("Sphere\xc2\xa0"
                      "2",
                      "glib-W35"),
              "1:7");
}

TEST(Characters, NoBreakSpaceOfLatin1IsABlank) {
    EXPECT_EQ(numbersOf("Sphere\xa0\xa0"
                        "2 9 9"),
              (Numbers{2, 9, 9}));
}

TEST(Characters, ContinuationByteA0IsPartOfALetter) {
    EXPECT_EQ(textOf("Obj \xc3\xa0.obj"), "\xc3\xa0.obj");
    EXPECT_TRUE(idsOf("Obj \xc3\xa0.obj").empty());
}

TEST(Characters, NoBreakSpaceInACommentIsNotReported) {
    EXPECT_TRUE(idsOf("Teapot # a\xc2\xa0"
                      "b")
                    .empty());
}

TEST(Characters, CommandsAreMatchedWithoutCase) {
    EXPECT_EQ(read("sPHERE").commands.at(0).id, glib::commandOf("Sphere"));
    EXPECT_EQ(read("texture2d 5 a.bmp").commands.at(0).id, CommandId::texture2D);
    EXPECT_EQ(read("glend").commands.at(0).id, CommandId::glEnd);
}

TEST(Characters, NamesKeepTheirCase) {
    EXPECT_EQ(textOf("Vertex Dots.VERT"), "Dots.VERT");
    EXPECT_EQ(textOf("Program DOTS"), "DOTS");
    EXPECT_EQ(tagsOf("Program P uKa 1 UKA 2"), (Words{"uKa", "UKA"}));
}

TEST(Characters, HeaderIsAComment) {
    EXPECT_TRUE(idsOf("##OpenGL GLIB\n").empty());
}

TEST(Comments, HashEndsTheCodeAnywhere) {
    EXPECT_EQ(numbersOf("Sphere 2 #9 9"), (Numbers{2, 60, 60}));
    EXPECT_EQ(textOf("Obj cow.obj##OpenGL GLIB"), "cow.obj");
}

TEST(Comments, TwoSlashesEndTheCodeAnywhere) {
    EXPECT_EQ(textOf("Obj models//cow.obj"), "models");
    EXPECT_TRUE(idsOf("// Spere\n").empty());
    EXPECT_TRUE(idsOf("Obj models//cow.obj").empty());
}

TEST(Comments, SingleSlashAtATokensBeginningIsACommentWithAWarning) {
    EXPECT_EQ(idsOf("Obj /home/cow.obj"), Ids{"glib-W01"});
    EXPECT_EQ(placeOf("Obj /home/cow.obj", "glib-W01"), "1:5");
    EXPECT_EQ(textOf("Obj /home/cow.obj"), "");
    EXPECT_EQ(idsOf("/ Spere"), Ids{"glib-W01"});
    EXPECT_EQ(idsOf("Sphere [2]/3"), (Ids{"glib-W10", "glib-W01"}));
}

TEST(Comments, SlashInsideATokenSeparatesFolders) {
    EXPECT_EQ(textOf("Obj models/cow.obj"), "models/cow.obj");
}

TEST(Comments, QuotedTokenHoldsThemAll) {
    EXPECT_EQ(textOf("Obj \"/a b//c#d<e>.obj\" # x"), "/a b//c#d<e>.obj");
    EXPECT_TRUE(idsOf("Obj \"/a b//c#d.obj\"").empty());
}

TEST(Comments, MessageTextHoldsThemAll) {
    EXPECT_EQ(textOf("MessageBox  a # b // c / d \"e \\  \n"), "a # b // c / d \"e \\");
    EXPECT_TRUE(idsOf("MessageBox a # b // c / d \"e <f \\\nTeapot").empty());
}

TEST(Comments, MessageBoxLineIsNotContinued) {
    EXPECT_EQ(wordsOf("MessageBox press a key \\\nTeapot"), (Words{"MessageBox", "Teapot"}));
}

TEST(Comments, BackslashInACommentIsPartOfIt) {
    EXPECT_EQ(wordsOf("Sphere 1 # big \\\nTeapot"), (Words{"Sphere", "Teapot"}));
    EXPECT_TRUE(idsOf("Sphere 1 # big \\\nTeapot").empty());
}

TEST(Tokens, BracketsNeedNoBlanks) {
    const Script script = read("Program P uA<0 .5 1>uB{1 0 0}uC[1 2]");
    ASSERT_EQ(script.commands.size(), 1U);
    EXPECT_EQ(tagsOf("Program P uA<0 .5 1>uB{1 0 0}uC[1 2]"), (Words{"uA", "uB", "uC"}));
    EXPECT_TRUE(script.diagnostics.empty());
}

TEST(Tokens, UnclosedQuoteIsRefused) {
    EXPECT_EQ(idsOf("Obj \"cow.obj\nTeapot"), Ids{"glib-E02"});
    EXPECT_EQ(placeOf("Obj \"cow.obj\nTeapot", "glib-E02"), "1:5");
    EXPECT_EQ(wordsOf("Obj \"cow.obj\nTeapot"), Words{"Teapot"});
}

TEST(Tokens, QuotedWordIsNoCommandAndNoNumber) {
    EXPECT_EQ(idsOf("\"Teapot\""), Ids{"glib-E01"});
    EXPECT_EQ(idsOf("Translate \"2\" 0 0"), Ids{"glib-W05"});
    EXPECT_EQ(textOf("Texture2D 6 \"512\""), "512");
}

TEST(Tokens, QuoteInsideAWordIsAnOrdinaryByte) {
    EXPECT_EQ(textOf("Obj a\"b.obj"), "a\"b.obj");
}

TEST(Tokens, CommasAndSemicolonsAtTheEndAreDropped) {
    EXPECT_EQ(numbersOf("Color 1., .5; 0,;"), (Numbers{1, .5, 0, 1}));
    EXPECT_EQ(idsOf("Color 1., .5; 0,;"), Ids{"glib-W03"}) << "one message per line";
    EXPECT_EQ(textOf("Obj cow.obj;"), "cow.obj");
    EXPECT_EQ(wordsOf("Teapot;"), Words{"Teapot"});
}

TEST(Tokens, CommaAloneIsNothing) {
    EXPECT_EQ(numbersOf("Color 1 , .5 , 0"), (Numbers{1, .5, 0, 1}));
    EXPECT_EQ(idsOf("Color 1 , .5 , 0\nColor 1, 0 0"), (Ids{"glib-W03", "glib-W03"}));
}

TEST(Tokens, BackslashInsideATokenIsAPathCharacter) {
    EXPECT_EQ(textOf("Obj C:\\models\\cow.obj"), "C:\\models\\cow.obj");
    EXPECT_TRUE(idsOf("Obj C:\\models\\cow.obj").empty());
}

TEST(Tokens, ColumnsCountBytesAndTabsAsOne) {
    EXPECT_EQ(placeOf("\t\tColor 1 .5 2", "glib-W26"), "1:14");
}

}  // namespace
}  // namespace glibra::glib::test
