// Templates that are filled with texts and rows.

#include "base/page_template.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace glibra::base {
namespace {

TEST(PageTemplate, EscapesTextsUnlessTheTemplateSaysOtherwise) {
    const Fields fields = {{"name", "<a> & b"}};
    EXPECT_EQ(filled("{{name}} {{{name}}} {{unknown}}.", fields), "&lt;a&gt; &amp; b <a> & b .");
    constexpr auto marked = [](std::string_view text) { return "[" + std::string(text) + "]"; };
    EXPECT_EQ(filled("{{name}}{{{name}}}", fields, marked), "[<a> & b]<a> & b");
}

TEST(PageTemplate, DoesNotSearchWhatItPutsIn) {
    EXPECT_EQ(filled("{{{a}}}", {{"a", "{{b}}{{#b}}"}, {"b", "no"}}), "{{b}}{{#b}}");
}

TEST(PageTemplate, RepeatsABlockForEachRowAndLooksAroundIt) {
    const std::vector<Fields> rows = {{{"name", "x"}, {"size", 3}}, {{"name", "y"}, {"size", .5}}};
    const Fields fields = {{"rows", rows}, {"name", "outside"}, {"unit", "px"}};
    EXPECT_EQ(filled("{{#rows}}{{^first}}, {{/first}}{{name}} {{size}} {{unit}}{{/rows}}; {{name}}", fields),
              "x 3 px, y 0.5 px; outside");
}

TEST(PageTemplate, TextsOfAListAreRows) {
    const std::vector<std::string> words = {"a", "<", "c"};
    EXPECT_EQ(
        filled("{{?words}}({{#words}}{{^first}}|{{/first}}{{.}}{{/words}}){{/?words}}", {{"words", words}}),
        "(a|&lt;|c)");
    EXPECT_EQ(
        filled("{{?words}}({{#words}}{{.}}{{/words}}){{/?words}}", {{"words", std::vector<std::string>()}}),
        "");
}

TEST(PageTemplate, ConditionsAreTextsOrTruths) {
    const Fields fields = {{"yes", true}, {"no", false}, {"empty", ""}, {"zero", 0}};
    EXPECT_EQ(
        filled("{{#yes}}1{{/yes}}{{#no}}2{{/no}}{{#empty}}3{{/empty}}{{#zero}}4{{/zero}}{{#gone}}5{{/gone}}",
               fields),
        "14");
    EXPECT_EQ(filled("{{^yes}}1{{/yes}}{{^no}}2{{/no}}{{^empty}}3{{/empty}}{{^gone}}5{{/gone}}", fields),
              "235");
}

TEST(PageTemplate, ARowHidesWhatIsAroundItEvenIfItIsEmpty) {
    const std::vector<Fields> rows = {{{"note", ""}}, {{"note", "inside"}}};
    EXPECT_EQ(
        filled("{{#rows}}{{note}}{{^note}}none{{/note}} {{/rows}}", {{"rows", rows}, {"note", "around"}}),
        "none inside ");
}

TEST(PageTemplate, PartsAreFilledWhereTheyAreNamed) {
    const std::vector<Fields> rows = {{{"name", "x"}}, {{"name", "y"}}};
    EXPECT_EQ(filled("{{=item}}<{{{name}}}>{{/item}}{{#rows}}{{>item}}{{/rows}}{{>item}}",
                     {{"rows", rows}, {"name", "z"}}),
              "<x><y><z>");
}

TEST(PageTemplate, ALineWithATagAloneIsNoLine) {
    const std::vector<std::string> words = {"a", "b"};
    EXPECT_EQ(
        filled(
            "{{=part}}\nof part\n{{/part}}\nbegin\n{{#words}}\n  {{.}}\n{{/words}}\n{{>part}}\nend {{>part}}",
            {{"words", words}}),
        "begin\n  a\n  b\nof part\nend of part\n");
    EXPECT_EQ(filled("x {{#words}}\n{{.}}{{/words}}\n", {{"words", words}}), "x \na\nb\n");
}

TEST(PageTemplate, MakesRowsOfRangesAndOptionalValues) {
    const auto fields = [](int value) { return Fields{{"value", value}}; };
    EXPECT_EQ(filled("{{#all}}{{value}} {{/all}}", {{"all", rowsOf(std::vector{1, 2}, fields)}}), "1 2 ");
    EXPECT_EQ(rowsOf(std::optional(7), fields).size(), 1U);
    EXPECT_TRUE(rowsOf(std::optional<int>(), fields).empty());
    EXPECT_EQ(titledRows({{"a", "x"}, {"b", ""}}).size(), 1U);
    EXPECT_EQ(leftOut(12, 10), "2");
    EXPECT_EQ(leftOut(10, 10), "");
}

}  // namespace
}  // namespace glibra::base
