#include "source/scene_head.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glibra::source::test {
namespace {

using Texts = std::vector<std::string>;

TEST(SceneHead, HasTheIdsTheSentenceAndTheText) {
    const SceneHead head = headOf(
        "# SH113 EX5.5, Gx9.4 Compact disc: a rainbow.\n# More of it.\n#\n# 1. Do it.\nWindowSize 9 9\n# "
        "no\n");
    EXPECT_EQ(head.rows, (Texts{"SH113", "EX5.5", "Gx9.4"}));
    EXPECT_EQ(head.summary, "Compact disc: a rainbow.");
    EXPECT_EQ(head.text, (Texts{"Compact disc: a rainbow.", "More of it.", "", "1. Do it."}));
}

TEST(SceneHead, ASentenceMayGoOnInTheNextLine) {
    EXPECT_EQ(headOf("# G7.2 A ball that\n# turns. And more.\n").summary, "A ball that turns.");
    EXPECT_EQ(headOf("# A ball\n#\n# Another paragraph.\n").summary, "A ball");
    EXPECT_EQ(headOf("# 3D is no id, nor is Sphere2 or ABC1.\n").rows, Texts{});
}

TEST(SceneHead, IsEmptyWithoutAComment) {
    for (const char* each : {"", "\n", "Sphere\n# late\n", "#", "#\n#\n", "# \r\n"}) {
        const SceneHead head = headOf(each);
        EXPECT_EQ(head.summary, "") << each;
        EXPECT_EQ(head.rows, Texts{}) << each;
        EXPECT_EQ(head.text, Texts{}) << each;
    }
}

TEST(Chapters, AreTheLastColumnOfATableOfScenes) {
    const auto chapters = chapterColumn(
        "# Scenes\n\n| scene | what | source |\n|---|---|---|\n"
        "| [a/b](a/b.glib) | one \\| two | Graphics Shaders, chapter 4 |\n"
        "| [c](c.glib) | three | - |\n| [broken](x | y |\n| [d](d.glib) | four | Slides |\r\n");
    EXPECT_EQ(chapters.size(), 2U);
    EXPECT_EQ(chapters.at("a/b.glib"), "Graphics Shaders, chapter 4");
    EXPECT_EQ(chapters.at("d.glib"), "Slides");
}

TEST(Chapters, BelongToEveryFileThatACellLinksTo) {
    for (const char* each : {"[a](a%20b/x.glib)", "[a](./a%20b/x.glib)", "[a](<a b/x.glib>)",
                             "**[a](a%20b/x.glib)**", "[a](a%20b/x.glib \"title\")",
                             "[o](o.glib), [a](a%20b/x.glib)", "![p](p.png) [a](c/../a%20b/x.glib)"}) {
        const auto chapters = chapterColumn("| " + std::string(each) + " | [w](w.glib) | Slides |\n");
        ASSERT_TRUE(chapters.contains("a b/x.glib")) << each;
        EXPECT_EQ(chapters.at("a b/x.glib"), "Slides") << each;
        EXPECT_FALSE(chapters.contains("w.glib")) << "it stands in the second column";
    }
    EXPECT_TRUE(chapterColumn("| [a](100%.glib) | w | S |").contains("100%.glib"));
    EXPECT_TRUE(chapterColumn("| [a](a%2.glib) | w | S |").contains("a%2.glib"));
}

TEST(Chapters, AreSingleOnes) {
    EXPECT_EQ(chaptersIn("Graphics Shaders, chapters 3, 4 and 12; Slides; B, chapter 2"),
              (Texts{"Graphics Shaders, chapter 3", "Graphics Shaders, chapter 4",
                     "Graphics Shaders, chapter 12", "Slides", "B, chapter 2"}));
    EXPECT_EQ(chaptersIn(""), Texts{});
    EXPECT_EQ(chaptersIn(" ; ;"), Texts{});
}

TEST(Chapters, AreOrderedByTheirNumbers) {
    EXPECT_TRUE(isBefore("Book, chapter 9", "Book, chapter 10"));
    EXPECT_FALSE(isBefore("Book, chapter 10", "Book, chapter 9"));
    EXPECT_TRUE(isBefore("a", "B"));
    EXPECT_TRUE(isBefore("Book", "Book, chapter 1"));
    EXPECT_FALSE(isBefore("x 007", "x 7"));
    EXPECT_FALSE(isBefore("x 7", "x 007"));
}

}  // namespace
}  // namespace glibra::source::test
