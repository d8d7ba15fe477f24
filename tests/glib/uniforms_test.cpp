// The Program statement (language, 5.1), the forms of values (5.2), and the counts in 5.3 that need no type.

#include <gtest/gtest.h>

#include "scene.h"

namespace glibra::glib::test {
namespace {

UniformSpec firstTag(std::string_view text) {
    const Script script = read(text);
    if (script.commands.empty() || script.commands[0].uniforms.empty()) return {};
    return script.commands[0].uniforms[0];
}

TEST(Name, MayBeACommandWord) {
    EXPECT_EQ(textOf("Program Texture TexUnit 6"), "Texture");
    EXPECT_EQ(textOf("Program Geometry"), "Geometry");
    EXPECT_EQ(tagsOf("Program Texture TexUnit 6"), Words{"TexUnit"});
    EXPECT_TRUE(idsOf("Program Texture TexUnit 6").empty());
}

TEST(Name, MayHaveSeveralWordsOnItsLine) {
    EXPECT_EQ(textOf("Program Final Project \\\n uA 1"), "Final Project");
    EXPECT_EQ(idsOf("Program Final Project \\\n uA 1"), Ids{"glib-W16"});
    EXPECT_EQ(tagsOf("Program Final Project uB 2 \\\n uA 1"), (Words{"uB", "uA"}));
    EXPECT_EQ(textOf("Program Final \\\n uA uB 1"), "Final");
    EXPECT_TRUE(idsOf("Program \"Final Project\" uA 1").empty());
}

TEST(Name, MayBeginWithADigit) {
    EXPECT_EQ(textOf("Program 3DNoise uA 1"), "3DNoise");
}

TEST(Name, MissingIsTakenFromTheFragmentFile) {
    const Script script = read("Fragment shaders/cat.big.frag\nProgram uTexUnit 6\n");
    EXPECT_EQ(script.commands.at(1).text(), "cat.big");
    EXPECT_EQ(tagsOf("Fragment cat.frag\nProgram uTexUnit 6\n"), Words{"uTexUnit"});
    EXPECT_EQ(idsOf(script), Ids{"glib-W14"});
    EXPECT_EQ(read("Fragment C:\\cat.frag\nProgram").commands.at(1).text(), "cat");
    EXPECT_EQ(idsOf("Program"), Ids{"glib-W14"});
    EXPECT_EQ(read("Fragment cat.frag\nFragment\nProgram").commands.at(2).text(), "unnamed");
}

TEST(Pairs, TagFollowedByAWordIsSkipped) {
    EXPECT_EQ(tagsOf("Program P uB 2 uKa uKd 1"), (Words{"uB", "uKd"}));
    EXPECT_EQ(idsOf("Program P uB 2 uKa uKd 1"), Ids{"glib-W17"});
    EXPECT_EQ(idsOf("Program P uB 2 uKa"), Ids{"glib-W17"});
    EXPECT_EQ(placeOf("Program P uB 2 uKa", "glib-W17"), "1:16");
}

TEST(Pairs, ValueWithoutATagIsSkipped) {
    EXPECT_EQ(tagsOf("Program P uA 1 5 uB 2"), (Words{"uA", "uB"}));
    EXPECT_EQ(idsOf("Program P uA 1 5 uB 2"), Ids{"glib-W18"});
    EXPECT_EQ(idsOf("Program P uA 1 <0 1 2> uB 2"), Ids{"glib-W18"});
    EXPECT_EQ(messageOf("Program P uA 1 <0 1 2> uB 2", "glib-W18"), "value < 0 1 2 > has no tag, skipped");
    EXPECT_EQ(idsOf("Program P uA 1 >"), Ids{"glib-W18"});
}

TEST(Pairs, LastOfTwoEqualTagsCounts) {
    const Script script = read("Program P uTol 1 uB 2 uTol <0 1 5>");
    ASSERT_EQ(script.commands.at(0).uniforms.size(), 2U);
    EXPECT_EQ(script.commands[0].uniforms[0].form, UniformForm::range);
    EXPECT_EQ(idsOf(script), Ids{"glib-W19"});
    EXPECT_EQ(placeOf("Program P uTol 1 uB 2 uTol <0 1 5>", "glib-W19"), "1:23");
}

TEST(Pairs, ProgramsMayShareAName) {
    EXPECT_TRUE(idsOf("Program P uA 1\nProgram P uA 2").empty());
}

TEST(Forms, NumberListRangeSwitchColour) {
    EXPECT_EQ(firstTag("Program P u 5").form, UniformForm::number);
    EXPECT_EQ(firstTag("Program P u 5").values, Numbers{5});
    EXPECT_EQ(firstTag("Program P u [10. 5. 0.]").form, UniformForm::list);
    EXPECT_EQ(firstTag("Program P u [10. 5. 0.]").values, (Numbers{10, 5, 0}));
    EXPECT_EQ(firstTag("Program P u < 0 1 10 >").form, UniformForm::range);
    EXPECT_EQ(firstTag("Program P u < 0 1 10 >").values, (Numbers{0, 1, 10}));
    EXPECT_EQ(firstTag("Program P u <true>").form, UniformForm::truth);
    EXPECT_EQ(firstTag("Program P u <true>").values, Numbers{1});
    EXPECT_EQ(firstTag("Program P u < FALSE >").values, Numbers{0});
    EXPECT_EQ(firstTag("Program P u {1 .5 0}").form, UniformForm::color);
    EXPECT_EQ(firstTag("Program P u {1 .5 0 .2}").values, (Numbers{1, .5, 0, .2}));
}

TEST(Forms, RangeLimitsAreNotTouched) {
    EXPECT_EQ(firstTag("Program P u <.1 5 .01>").values, (Numbers{.1, 5, .01}));
    EXPECT_TRUE(idsOf("Program P u <.1 5 .01>").empty());
}

TEST(Forms, TruthAmongNumbersIsOneOrZero) {
    EXPECT_EQ(firstTag("Program P u [true false 1]").values, (Numbers{1, 0, 1}));
    EXPECT_EQ(idsOf("Program P u [true false 1]"), (Ids{"glib-W05", "glib-W05"}));
}

TEST(Counts, RangesOfOneTwoAndFourValues) {
    EXPECT_EQ(idsOf("Program P u <.5>"), Ids{"glib-W15"});
    EXPECT_EQ(messageOf("Program P u <.5>", "glib-W15"),
              "u: 1 value in < >; read as minimum 0, current .5, maximum 1");
    EXPECT_EQ(messageOf("Program P u <-2>", "glib-W15"),
              "u: 1 value in < >; read as minimum -2, current -2, maximum 1");
    EXPECT_EQ(messageOf("Program P u <7>", "glib-W15"),
              "u: 1 value in < >; read as minimum 0, current 7, maximum 7");
    EXPECT_EQ(messageOf("Program P u <3 2>", "glib-W15"),
              "u: 2 values in < >; read as minimum 3, current 2, maximum 3");
    EXPECT_EQ(idsOf("Program P u <0 1 2 3>"), Ids{"glib-W15"});
    EXPECT_EQ(firstTag("Program P u <3 2>").values, (Numbers{3, 2}));
}

TEST(Counts, ColoursOfOneTwoAndFiveValues) {
    EXPECT_EQ(idsOf("Program P u {1}"), Ids{"glib-W15"});
    EXPECT_EQ(idsOf("Program P u {1 0}"), Ids{"glib-W15"});
    EXPECT_EQ(idsOf("Program P u {1 0 0 1 1}"), Ids{"glib-W15"});
    EXPECT_EQ(placeOf("Program P u {1}", "glib-W15"), "1:13");
}

TEST(Counts, EmptyBracketsSkipTheTag) {
    for (const char* text : {"Program P u <> v 1", "Program P u [] v 1", "Program P u {} v 1"}) {
        EXPECT_EQ(tagsOf(text), Words{"v"}) << text;
        EXPECT_EQ(idsOf(text), Ids{"glib-W17"}) << text;
    }
}

TEST(Counts, ListsOfAnyLengthAreLeftToTheType) {
    EXPECT_TRUE(idsOf("Program P u [1] v [1 2 3 4 5 6 7]").empty());
}

}  // namespace
}  // namespace glibra::glib::test
