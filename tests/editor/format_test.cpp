#include "editor/format.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "../fuzz/random.h"
#include "example_scenes.h"
#include "glib/script.h"
#include "glib/text.h"

namespace glibra::test {
namespace {

using editor::formatted;

/// The text without blanks and line ends, in small letters: what formatting may not change.
std::string inked(std::string_view text) {
    std::string ink;
    for (const char c : text)
        if (std::string_view(" \t\v\f\r\n").find(c) == std::string_view::npos) ink += glib::lower(c);
    return ink;
}

/// What all formatted texts have in common with the texts that they are made from.
void expectSound(const std::string& text, const std::string& name) {
    const std::string once = formatted(text);
    EXPECT_EQ(formatted(once), once) << name;
    EXPECT_EQ(inked(once), inked(text)) << name;
    EXPECT_TRUE(editor::meanTheSame(text, once)) << name;
}

TEST(Format, IndentsBlocks) {
    EXPECT_EQ(formatted("group\nsphere\n  when (1)\n\tBox 1\n# here\n else\nCone\n  endwhen\nEndGroup\nCube"),
              "Group\n    Sphere\n    When (1)\n        Box 1\n        # here\n    Else\n        Cone\n"
              "    EndWhen\nEndGroup\nCube\n");
    EXPECT_EQ(formatted("glBegin triangles\nglVertex 0 0 0\nglEnd\nTransformBegin\nSphere\nTransformEnd\n"),
              "glBegin triangles\n    glVertex 0 0 0\nglEnd\nTransformBegin\n    Sphere\nTransformEnd\n");
}

TEST(Format, IgnoresEndsOfNothingAndBlocksWithoutEnd) {
    EXPECT_EQ(formatted(" PopMatrix\n  PushMatrix\n   Sphere\n"), "PopMatrix\nPushMatrix\nSphere\n");
}

TEST(Format, AlignsBackslashesAndMovesTheLinesThatContinueAStatement) {
    EXPECT_EQ(formatted("  Program A \\\n  uA 1\\\n      uLong <0 1 2>   \\\n uB 2\n"),
              "Program A         \\\n    uA 1          \\\n    uLong <0 1 2> \\\n    uB 2\n");
}

TEST(Format, KeepsCommentsTextsAndExpressions) {
    const std::string text =
        "Vertex \"two  words.vert\"  # a\tb  \nLet a (1  +\t2)\nLet b (1 + \\\n  2)\nMessageBox a \t b\n"
        "# tab\there  \n";
    EXPECT_EQ(formatted(text), text);
}

TEST(Format, MovesACommentThatGoesOnBelowItsBeginning) {
    EXPECT_EQ(formatted("  Sphere  # big\n          # ball\n"), "Sphere  # big\n        # ball\n");
}

TEST(Format, KeepsShadersInTheScene) {
    const std::string shader = "#version 330\n  void main()\t{ }  \n\n\n# not a comment\n";
    EXPECT_EQ(formatted("Group\nEndGroup\n  fragment   inline\n" + shader + "  EndFragment  \nProgram A\n"),
              "Group\nEndGroup\nFragment   inline\n" + shader + "EndFragment\nProgram A\n");
}

TEST(Format, LeavesFaultyStatementsAlone) {
    const std::string text = "  Sphere \"a\n   Nonsense  \t 1\n";
    EXPECT_EQ(formatted(text), text);
    const std::string open = "  Fragment inline\n  void main() {}\n  # x\n";
    EXPECT_EQ(formatted(open), open);
}

TEST(Format, KeepsLineEndsAndTheByteOrderMark) {
    EXPECT_EQ(formatted("\xef\xbb\xbf  Sphere\r\n  Box\r\n\r\n\r\n"), "\xef\xbb\xbfSphere\r\nBox\r\n");
    EXPECT_EQ(formatted(" Sphere\r Box"), "Sphere\rBox\r");
    EXPECT_EQ(formatted(""), "");
    EXPECT_EQ(formatted(" \n\n"), "");
}

TEST(Format, EverySceneOfTheProjectIsFormatted) {
    const std::vector<std::filesystem::path> scenes = exampleScenes();
    EXPECT_GT(scenes.size(), 400U);
    for (const std::filesystem::path& each : scenes) {
        const std::string text = textOf(each);
        EXPECT_TRUE(formatted(text) == text) << "glibra format " << each.string();
    }
}

TEST(Format, ChangesNothingThatAnySceneOfTheProjectMeans) {
    std::size_t same = 0;
    for (const std::filesystem::path& each : exampleScenes()) {
        const std::string text = textOf(each);
        expectSound(text, each.string());
        // Badly indented, it is formatted to the same text: no scene is so unusual that it is left alone.
        std::string shaken;
        fuzz::Random random(text.size());
        bool isShader = false;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string line = text.substr(begin, end - begin);
            if (line.starts_with("End")) isShader = false;
            if (!isShader && !line.empty() && line.find_first_not_of(' ') == 0)
                shaken.append(random.below(3), ' ');
            if (line.ends_with("inline")) isShader = true;
            shaken += line + "\n";
            begin = end + 1;
        }
        const std::string tidy = formatted(shaken);
        EXPECT_TRUE(shaken == text || tidy != shaken) << each;
        if (tidy == text) ++same;
    }
    EXPECT_GT(same, 10U);
}

TEST(Format, SpellsTheEndsOfShaders) {
    EXPECT_EQ(formatted("fragment inline\nvoid main() {}  \nendfragment\n"),
              "Fragment inline\nvoid main() {}  \nEndFragment\n");
    EXPECT_EQ(formatted("glsl lib inline\n\nendglsl\n"), "Glsl lib inline\n\nEndGlsl\n");
}

TEST(Format, IsSafeForChangedScenes) {
    fuzz::Random random(28);
    constexpr std::string_view kPieces[] = {
        "\\\n", "\n", "\"", "(",  ")",  "#",         "//",       "\t",
        "\r",   "{",  "}",  "/",  ",",  "inline\n",  "\nGroup",  "\nEndGroup\n",
        "<",    ">",  "\0", "\\", "  ", "\nProgram", "\xc2\xa0", "MessageBox "};
    const std::vector<std::filesystem::path> scenes = exampleScenes();
    std::size_t leftAlone = 0, count = 0;
    for (std::size_t i = 0; i < scenes.size(); i += 3) {
        std::string text = textOf(scenes[i]);
        for (int change = 0; change < 4; ++change) {
            const std::size_t at = random.below(text.size());
            if (random.oneIn(3))
                text.erase(at, random.below(40));
            else
                text.insert(at, random.oneOf(kPieces));
            expectSound(text, scenes[i].string() + "\n" + text);
            ++count;
            if (formatted(" \t" + text) == " \t" + text) ++leftAlone;
        }
    }
    EXPECT_LT(leftAlone, count / 10) << "of " << count;
}

TEST(Format, IsSafeForAnyBytes) {
    fuzz::Random random(5);
    for (int i = 0; i < 300; ++i) {
        std::string text;
        for (std::size_t left = random.below(120); left > 0; --left)
            text += random.oneIn(2) ? static_cast<char>(random.below(256))
                                    : "\\\n \t#\"(){}<>,;/GroupEnd"[random.below(22)];
        expectSound(text, text);
    }
}

}  // namespace
}  // namespace glibra::test
