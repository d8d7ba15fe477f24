// What expressions name: variables, arrays, cameras, choices, words; and what values depend on.

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "support.h"

namespace glibra::expression::test {
namespace {

constexpr std::array<std::string_view, 3> kCull{"off", "back", "front"};
constexpr std::array kWordOnly{Type::word()};
constexpr std::array kNumberOrVector{Type::number(), Type::vector(3)};

TEST(ExpressionNames, ReadFieldsOfRecordsAndArrays) {
    EXPECT_EQ(numberOf("light.near"), .5);
    EXPECT_EQ(numberOf("light.prev.near"), .25);
    EXPECT_EQ(numberOf("light.position.y"), 5);
    EXPECT_EQ(numberOf("light . position [ 2 ]"), 6);
    EXPECT_EQ(numberOf("slice[2].far"), 200);
    EXPECT_EQ(numberOf("slice[a - 1].far"), 100);
    EXPECT_EQ(numberOf("slice.far[1]"), 100);
    EXPECT_EQ(numberOf("slice.count"), 3);
    EXPECT_EQ(numberOf("pose[0] + pose[a + b]"), 25);
    EXPECT_EQ(numberOf("pose[pose.count - 1]"), 15);
    EXPECT_EQ(numberOf("points[1].y * points[0][1]"), 8);
    EXPECT_EQ(numberOf("mouse.x + mouse.y"), 1);
    EXPECT_TRUE(valueOf("mouse.down").truth());
    EXPECT_EQ(numberOf("brick.size.x / brick.size.y"), 2);
    EXPECT_EQ(numberOf("window.x / window.y - aspect"), 0);
}

TEST(ExpressionNames, ReportUnknownOnesWithASuggestion) {
    const std::vector<std::pair<std::string, std::string>> reported{
        {"a + windw.x", "expr-E02 'windw': unknown name 'windw'; did you mean 'window'?"},
        {"tru", "expr-E02 'tru': unknown name 'tru'; did you mean 'true'?"},
        {"(nothing)", "expr-E02 'nothing': unknown name 'nothing'"},
        {"nothing == 1", "expr-E02 'nothing': unknown name 'nothing'"},
        {"1 + nothing", "expr-E02 'nothing': unknown name 'nothing'"},
        {"-nothing", "expr-E02 'nothing': unknown name 'nothing'"},
        {"sin(nothing)", "expr-E02 'nothing': unknown name 'nothing'"},
        {"nothing.x", "expr-E02 'nothing': unknown name 'nothing'"},
        {"v[nothing]", "expr-E02 'nothing': unknown name 'nothing'"},
        {"nothing ? 1 : 2", "expr-E02 'nothing': unknown name 'nothing'"},
        {"yes ? nothing : 2", "expr-E02 'nothing': unknown name 'nothing'"},
        {"yes && nothing", "expr-E02 'nothing': unknown name 'nothing'"},
        {"Time", "expr-E02 'Time': unknown name 'Time'; did you mean 'time'?"},
        {"sinn(1)", "expr-E02 'sinn': unknown function 'sinn'; did you mean 'sin'?"},
        {"smoothStep(0, 1, a)",
         "expr-E02 'smoothStep': unknown function 'smoothStep'; did you mean 'smoothstep'?"},
        {"a(b + 1)", "expr-E08 'a': 'a' is a value, not a function; write '*' to multiply"},
        {"light.shadw", "expr-E02 'shadw': 'light' has no field 'shadw'; did you mean 'shadow'?"},
        {"light.x",
         "expr-E02 'x': 'light' has no field 'x'; it has aspect, direction, far, fov, inverseView, near, "
         "position, "
         "prev, projection, shadow, view and viewProjection"},
        {"pose.size", "expr-E02 'size': 'pose' has no field 'size'; it has count"},
        {"v.w", "expr-E02 'w': a vec3 has no component 'w'"},
        {"v.xg", "expr-E02 'xg': a vec3 has no component or field 'xg'"},
        {"v.xxxxx", "expr-E02 'xxxxx': a vec3 has no component or field 'xxxxx'"},
        {"m3.x", "expr-E02 'x': a mat3 has no component or field 'x'"},
        {"light",
         "expr-E08 'light': 'light' is a camera, not a value; use one of its fields aspect, direction, far, "
         "fov, inverseView, near, position, prev, projection, shadow, view and viewProjection"},
        {"pose + 1",
         "expr-E08 'pose': 'pose' is an array; use an element, pose[0] to pose[5], or pose.count"},
    };
    for (const auto& [text, expected] : reported) EXPECT_EQ(problemText(text), expected) << text;
}

TEST(ExpressionNames, WithoutAValueAreReported) {
    EXPECT_EQ(problemText("1 + light.far"), "expr-E07 'light.far': 'light.far' has no value here");
    class Cycle : public NameTable {
      public:
        using NameTable::NameTable;
        std::string whyMissing(std::uint32_t, std::size_t) const override {
            return "it is defined by itself";
        }
    };
    Cycle table;
    table.add("n", Type::number(), Depends::variable, 2);
    const auto expression = parse("n[1]", {"s.glib", 3, 9}, table);
    ASSERT_TRUE(expression);
    EXPECT_EQ(toString(expression->evaluate(table).problem.message),
              "s.glib:3:9: error: 'n[1]' has no value here: it is defined by itself [expr-E07]");
    table.set("n", 1. / 0., 1);
    EXPECT_EQ(expression->evaluate(table).problem.message.text, "'n[1]': the result is infinite");
}

TEST(ExpressionNames, SayWhatAValueCanChangeWith) {
    const std::vector<std::pair<std::string, Depends>> cases{
        {"1 + 2", Depends::nothing},
        {"pi * slice.count", Depends::nothing},
        {"dt", Depends::nothing},
        {"time", Depends::time},
        {"a * sin(time)", Depends::time | Depends::variable},
        {"bounce(0, 1, 2)", Depends::time},
        {"light.shadow * model", Depends::camera | Depends::model},
        {"slice[int(frame)].view", Depends::camera | Depends::frame},
        {"tick + window.x + mouse.y", Depends::tick | Depends::window | Depends::mouse},
        {"brick.size", Depends::texture},
        {"true ? a : time", Depends::variable},
        {"false && time > 1", Depends::nothing},
        {"no ? a : time", Depends::variable | Depends::time},
    };
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(static_cast<int>(parsed(text).depends()), static_cast<int>(expected)) << text;
    const Expression expression = parsed("b + a * b + light.near");
    ASSERT_EQ(expression.uses().size(), 3U);
    EXPECT_EQ(expression.uses()[0].path, "b");
    EXPECT_EQ(expression.uses()[1].path, "a");
    EXPECT_EQ(expression.uses()[2].path, "light.near");
    EXPECT_EQ(expression.uses()[2].symbol.depends, Depends::camera);
}

TEST(ExpressionNames, WordsStandWhereTheStatementAcceptsThem) {
    const NameTable table = sceneTable();
    const Wanted cull{kWordOnly, kCull};
    const auto wordOf = [&](std::string_view text) {
        const Value value = *parsed(text, cull).evaluate(table);
        EXPECT_EQ(value.type, Type::word());
        return kCull.at(value.word());
    };
    EXPECT_EQ(wordOf("yes ? front : back"), "front");
    EXPECT_EQ(wordOf("no ? front : a > b ? off : (back)"), "back");
    EXPECT_EQ(wordOf("front"), "front");
    EXPECT_EQ(problemText("yes ? front : bak", cull),
              "expr-E02 'bak': unknown name 'bak'; did you mean 'back'?");
    EXPECT_EQ(problemText("a", cull), "expr-E03 'a': expected off, back or front, found number");
    EXPECT_EQ(problemText("front + 1", cull), "expr-E03 'front + 1': '+' does not combine word and number");
    EXPECT_EQ(problemText("front == back", cull),
              "expr-E03 'front == back': '==' does not combine word and word");
    EXPECT_EQ(problemText("yes ? front : 1", cull),
              "expr-E03 'yes ? front : 1': both cases of '?' have the same type, found word and number");
    EXPECT_EQ(problemText("front"), "expr-E02 'front': unknown name 'front'");
}

TEST(ExpressionNames, ChoicesCompareWithTheirWords) {
    EXPECT_TRUE(valueOf("color == green").truth());
    EXPECT_TRUE(valueOf("red != color").truth());
    EXPECT_EQ(numberOf("color == (blue) ? 1 : 2"), 2);
    EXPECT_EQ(numberOf("color + 1"), 2) << "it counts its words";
    EXPECT_EQ(problemText("color == gren"),
              "expr-E02 'gren': unknown word 'gren'; color is red, green or blue");
    EXPECT_EQ(problemText("a == green"), "expr-E02 'green': unknown name 'green'");
}

TEST(ExpressionNames, AChoiceWhoseWordsAreAcceptedStandsForItsWord) {
    NameTable table = sceneTable();
    table.add("side", {.type = Type::number(), .words = {"front", "off"}, .what = {}});
    const auto expression = parse("side", {}, table, {kWordOnly, kCull});
    ASSERT_TRUE(expression);
    table.set("side", 0.);
    EXPECT_EQ(kCull.at(expression->evaluate(table)->word()), "front");
    table.set("side", 1);
    EXPECT_EQ(kCull.at(expression->evaluate(table)->word()), "off");
    table.set("side", 2);
    EXPECT_EQ(expression->evaluate(table).problem.message.text, "'side': subscript 2 is not between 0 and 1");
    EXPECT_EQ(problemText("color", {kWordOnly, kCull}),
              "expr-E03 'color': color may be 'red'; expected off, back or front");
}

TEST(ExpressionNames, OnlyWantedTypesAreAccepted) {
    EXPECT_EQ(problemText("u", {kNumberOrVector, {}}), "expr-E03 'u': expected number or vec3, found vec2");
    EXPECT_EQ(problemText("yes", {kNumberOrVector, {}}),
              "expr-E03 'yes': expected number or vec3, found bool");
    EXPECT_EQ(parsed("v", {kNumberOrVector, {}}).type(), Type::vector(3));
}

TEST(ExpressionNames, ADeclaredNameHidesAConstant) {
    NameTable table;
    table.add("pi", Type::number(), Depends::variable);
    table.set("pi", 3);
    EXPECT_EQ(parse("pi", {}, table)->evaluate(table)->number(), 3);
}

}  // namespace
}  // namespace glibra::expression::test
