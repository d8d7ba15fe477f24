// Which parentheses are expressions, what classic commands make of them, and classic scenes that are
// unchanged.

#include <gtest/gtest.h>

#include <string>

#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/number.h"
#include "glib/parse/arguments.h"
#include "glib/statement_table.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

bool isExpression(const std::string& text) {
    return ExpressionFinder(text, 0).endAt(0, Parentheses::byContent) != 0;
}

TEST(Parentheses, AreExpressionsWithAWordOrAnOperator) {
    for (const char* text :
         {"(size)", "(a.b)", "(_x)", "(2*3)", "(1-2)", "(1 - 2)", "(-x)", "(-(2))", "(1+2)", "(8/2)", "(5%2)",
          "(1==2)", "(!1)", "(1&2)", "(1|2)", "(1 2 3 sin(4))", "(e5)", "(true || 1)", "(1e5 + 2)"})
        EXPECT_TRUE(isExpression(text)) << text;
}

TEST(Parentheses, AreBracketsAroundPlainNumbers) {
    for (const char* text : {"(1)", "(1 .5 0)", "(1, .5, 0)", "(-1 +2 -.5)", "(1e-3 2E+5)", "(true)",
                             "(FALSE)", "(1.5f)", "(?)", "(1 <2> {3})", "()", "(1 (2 3))", "(\"a b\" 1)"})
        EXPECT_FALSE(isExpression(text)) << text;
}

TEST(Parentheses, EndBeforeAComment) {
    EXPECT_FALSE(isExpression("(a # )"));
    EXPECT_FALSE(isExpression("(a // )"));
    EXPECT_FALSE(isExpression("(a"));
    EXPECT_EQ(ExpressionFinder("(a(b)c) d)", 0).endAt(0, Parentheses::byContent), 7U);
    EXPECT_EQ(ExpressionFinder("(1)", 0).endAt(0, Parentheses::expressions), 3U);
}

TEST(Parentheses, OfALineAreFoundInOnePass) {
    std::string text;  // 60,000 openings and closings on one line, each looked at
    for (int i = 0; i < 30'000; ++i) text += '(';
    for (int i = 0; i < 30'000; ++i) text += ')';
    EXPECT_FALSE(read("Box " + text).diagnostics.empty());
    EXPECT_FALSE(read("Box " + std::string(60'000, '(')).diagnostics.empty());
}

TEST(ClassicCommands, KeepNumbersAndExpressionsForLater) {
    const Command box = read("Box (size) 2 (a + 1)").commands.at(0);
    EXPECT_TRUE(box.isEvaluatedLater);
    EXPECT_TRUE(box.numbers.empty());
    ASSERT_EQ(box.values.size(), 3U);
    EXPECT_EQ(box.values[0].text, "size");
    EXPECT_EQ(box.values[1].number, 2);
    EXPECT_EQ(box.values[2].text, "a + 1");
    EXPECT_TRUE(read("Box (size)").isModern);
    EXPECT_FALSE(read("Box 1 2 3").isModern);
}

TEST(ClassicCommands, WithoutExpressionsAreUnchanged) {
    EXPECT_EQ(numbersOf("Color (1 .5 0)"), (std::vector<double>{1, .5, 0, 1}));
    EXPECT_EQ(idsOf("Color (1 .5 0)"), Ids{"glib-W10"});
    EXPECT_EQ(idsOf("Program P uA (1 2)"), (Ids{"glib-W10"}));
    EXPECT_EQ(idsOf("Obj cow(old).obj"), (Ids{"glib-W10", "glib-W07"}));
    EXPECT_EQ(idsOf("Triangles [(a) 0 0] 1 1 1 2 2 2"), Ids{"glib-E24"});
    EXPECT_EQ(textOf("Fragment inline"), "no command");
    EXPECT_EQ(idsOf("Clear color"), Ids{"glib-W07"});
}

TEST(ClassicScenes, LineAfterAProgramIsATagUnlessTheSceneIsModern) {
    const Script classic = read("Program P\n Step .1\n uA 1");
    EXPECT_EQ(idsOf(classic), (Ids{"glib-W11", "glib-W11"}));
    EXPECT_FALSE(classic.isModern);
    EXPECT_EQ(tagsOf("Program P \\\n Step .1 \\\n Fps 2"), (std::vector<std::string>{"Step", "Fps"}));
    const Script modern = read("Program P\nStep .1\nEndStep");
    EXPECT_EQ(idsOf(modern), Ids{});
    EXPECT_EQ(modern.commands.size(), 3U);
    EXPECT_EQ(idsOf("Program P\nInstances 5\nState cull back"), Ids{});
    EXPECT_EQ(read("Clear depth\nFps 30").commands.at(0).id, CommandId::clearParts);
    EXPECT_EQ(read("Clear\nFps 30").commands.at(0).id, CommandId::clear);
}

/// Numbers for every argument and beyond: few, all, too many; in and out of range.
std::vector<std::vector<double>> trials(std::size_t arguments) {
    std::vector<std::vector<double>> all;
    for (std::size_t count = 0; count <= arguments + 1; ++count)
        for (const double value : {0., 1., -2., 2.5, 300., 1e6}) {
            std::vector<double> numbers(count, value);
            for (std::size_t i = 1; i < count; i += 2) numbers[i] = value + 1;
            all.push_back(numbers);
        }
    return all;
}

TEST(EvaluatedNumbers, MeanWhatTheSameNumbersInTheFileMean) {
    std::size_t compared = 0;
    for (const StatementRow& row : commandTable()) {
        if (!takesNumbers(row)) continue;
        for (const std::vector<double>& numbers : trials(argumentsOf(row).size())) {
            std::string text(row.name);
            std::vector<EvaluatedNumber> evaluated;
            for (const double each : numbers) {
                text += ' ';
                evaluated.push_back({each, {1, static_cast<int>(text.size()) + 1}, true});
                text += numberText(each);
            }
            const Script literal = read(text);
            Command command;
            command.id = row.id;
            MessageLog log("scene.glib");
            evaluateNumbers(row, command, evaluated, log);
            const Diagnostics messages = log.take();
            ASSERT_EQ(messages.size(), literal.diagnostics.size()) << text;
            for (std::size_t i = 0; i < messages.size(); ++i)
                EXPECT_EQ(toString(messages[i]), toString(literal.diagnostics[i]));
            if (literal.commands.empty()) continue;
            EXPECT_EQ(command.numbers, literal.commands[0].numbers) << text;
            EXPECT_EQ(command.givenNumbers, literal.commands[0].givenNumbers) << text;
            ++compared;
        }
    }
    EXPECT_GT(compared, 500U);
}

TEST(EvaluatedNumbers, AreCutSilentlyAndMustBeFinite) {
    const StatementRow& sphere = *findCommand("Sphere");
    Command command;
    MessageLog log("scene.glib");
    evaluateNumbers(sphere, command, std::vector<EvaluatedNumber>{{1, {1, 8}}, {10.5, {1, 12}}}, log);
    EXPECT_TRUE(log.take().empty());
    EXPECT_EQ(command.numbers, (std::vector<double>{1, 10, 60}));
    MessageLog second("scene.glib");
    evaluateNumbers(sphere, command, std::vector<EvaluatedNumber>{{1e300, {1, 8}}}, second);
    const Diagnostics messages = second.take();
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(toString(messages[0]),
              "scene.glib:1:8: error: Sphere: radius 1e+300 is not finite as a 32-bit float [glib-E31]");
}

}  // namespace
}  // namespace glibra::glib::test
