// Words and malformed numbers inside [ ], { } and < > of modern scenes are errors that say what to write.

#include <gtest/gtest.h>

#include <string>

#include "scene.h"

namespace glibra::glib::test {
namespace {

constexpr const char* kBegin = "Let h 2\n";

/// The errors of a script in which `h` is a variable.
std::string errorsOf(const std::string& line) {
    const Script script = read(kBegin + line);
    std::string all;
    for (const Diagnostic& each : script.diagnostics)
        all += std::to_string(each.place.line) + ":" + std::to_string(each.place.column) + " " + each.id +
               " " + each.text + "\n";
    return all;
}

TEST(ItemsOfBrackets, SayWhatToWriteForNamesAndExpressions) {
    const auto message = [&](const std::string& place, const std::string& word, const std::string& what) {
        return place + " glib-E19 " + word + ": expected a number or (expression), found '" + what +
               "'; write (" + what + ") for its value\n";
    };
    EXPECT_EQ(errorsOf("Let p [1 h 3]"), message("2:10", "Let", "h"));
    EXPECT_EQ(errorsOf("Let p [1 h*2 3]"), message("2:10", "Let", "h*2"));
    EXPECT_EQ(errorsOf("Let p [1 2 -pi]"), message("2:12", "Let", "-pi"));
    EXPECT_EQ(errorsOf("Buffer b float [1 h 3]"), message("2:19", "Buffer", "h"));
    EXPECT_EQ(errorsOf("Program P uV [h 1]"), message("2:15", "Program", "h"));
    EXPECT_EQ(errorsOf("Set kd [1 h 1]"), message("2:11", "Set", "h"));
    EXPECT_EQ(errorsOf("Fill window with P kd [1 h 1]"), message("2:26", "Fill", "h"));
    EXPECT_EQ(errorsOf("Expect pixel 0 0 [0 h 0]"), message("2:21", "Expect", "h"));
    EXPECT_EQ(errorsOf("Let c {h 1 0}"), message("2:8", "Let", "h"));
    EXPECT_EQ(errorsOf("Let r <0 h 1>"), message("2:10", "Let", "h"));
    EXPECT_EQ(errorsOf("Let p [1 vec3(h, 0, 0)]").substr(0, 13), "2:10 glib-E19");
    EXPECT_NE(errorsOf("Let p [1 vec3(h, 0, 0)]").find("write (vec3(h, 0, 0)) for its value"),
              std::string::npos);
    EXPECT_EQ(errorsOf("Let p [1 (h) 3]"), "");
}

TEST(ItemsOfBrackets, AreNumbersFromTheFirstByteToTheLast) {
    EXPECT_EQ(errorsOf("Let p [1 2x 3]"), "2:10 glib-E19 Let: '2x' is not a number\n");
    EXPECT_EQ(errorsOf("Buffer b float 4 [1 .5x 2]"), "2:21 glib-E19 Buffer: '.5x' is not a number\n");
    EXPECT_EQ(errorsOf("Buffer b float 4 [typo 1 2]"),
              "2:19 glib-E19 Buffer: expected a number or (expression), found 'typo'\n");
}

TEST(ItemsOfBrackets, HaveBlanksBetweenThem) {
    EXPECT_EQ(errorsOf("Let a [1,2,3]"),
              "2:8 glib-E19 Let: '1,2,3' is not a number; write blanks between the values: [1 2 3]\n");
    EXPECT_EQ(errorsOf("Let a <0,1,2>"),
              "2:8 glib-E19 Let: '0,1,2' is not a number; write blanks between the values: <0 1 2>\n");
}

TEST(ItemsOfBrackets, MayBeWordsInChoicesAndRepeat) {
    EXPECT_EQ(errorsOf("Let view <left right>"), "");
    EXPECT_EQ(errorsOf("Repeat [a b c] as w\nEndRepeat"), "");
    EXPECT_EQ(errorsOf("Let views [left right]"),
              "2:12 glib-E19 Let: expected a number or (expression), found 'left'; a choice of words stands "
              "in < >\n");
    EXPECT_NE(errorsOf("Set maps [red green]").find("objects have a tag each"), std::string::npos);
}

TEST(Messages, NameVariablesThatAreReadAsFiles) {
    EXPECT_EQ(errorsOf("Texture2D a h 30 rgba8"),
              "2:13 glib-E19 Texture2D: expected a number, found 'h'; write (h) for its value\n");
}

TEST(Messages, NameParenthesesThatAreNotClosed) {
    EXPECT_EQ(errorsOf("Box (h"), "2:5 glib-E20 Box: '(' is not closed on this line\n");
    EXPECT_EQ(errorsOf("Box (size"), "2:5 glib-E20 Box: '(' is not closed on this line\n");
    EXPECT_EQ(idsOf("Box (size\nPass window\nEndPass"), Ids{"glib-E20"});
    EXPECT_EQ(idsOf("Box (size"), (Ids{"glib-W10", "glib-W09", "glib-W05", "glib-W42"}))
        << "classic scenes close it";
}

TEST(ItemsOfBrackets, OfProgramsAreTolerantOnlyInClassicScenes) {
    const std::string pass = "Pass window\nEndPass\n";
    EXPECT_EQ(idsOf("Program P kd [1 x 1]"), (Ids{"glib-W09", "glib-W18"}));
    EXPECT_EQ(idsOf("Program P kd [1 x 1]\n" + pass), Ids{"glib-E19"});
    EXPECT_EQ(idsOf(pass + "Program P kd [1 x 1]"), Ids{"glib-E19"});
    for (const std::string tag : {"kd [1 2x 1]", "kd 2x"}) {
        EXPECT_EQ(idsOf("Program P " + tag), Ids{"glib-W04"}) << tag;
        EXPECT_EQ(idsOf("Program P " + tag + "\n" + pass), Ids{"glib-E19"}) << tag;
        EXPECT_EQ(idsOf(pass + "Program P " + tag), Ids{"glib-E19"}) << tag;
    }
}

}  // namespace
}  // namespace glibra::glib::test
