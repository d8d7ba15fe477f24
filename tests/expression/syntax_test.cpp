// Literals, precedence and places.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support.h"

namespace glibra::expression::test {
namespace {

TEST(ExpressionSyntax, ReadsTheLiteralsOfGlsl) {
    EXPECT_EQ(numberOf("1"), 1);
    EXPECT_EQ(numberOf("1."), 1);
    EXPECT_EQ(numberOf(".5"), .5);
    EXPECT_EQ(numberOf("1.5e3"), 1500);
    EXPECT_EQ(numberOf("1E-2"), .01);
    EXPECT_EQ(numberOf("2e+1"), 20);
    EXPECT_EQ(numberOf("1.5f"), 1.5);
    EXPECT_EQ(numberOf("1.5lf"), 1.5);
    EXPECT_EQ(numberOf("7u"), 7);
    EXPECT_EQ(numberOf("0x1F"), 31);
    EXPECT_EQ(numberOf("010"), 10) << "no octal numbers";
    EXPECT_EQ(numberOf("0.1"), .1) << "correctly rounded";
    EXPECT_EQ(numberOf("1e-400"), 0);
    EXPECT_EQ(numberOf("0." + std::string(400, '0') + "1"), 0);
    EXPECT_EQ(numberOf("0e999999999999999999999"), 0);
    EXPECT_TRUE(valueOf("true").truth());
    EXPECT_EQ(numberOf("pi"), std::acos(-1.));
}

TEST(ExpressionSyntax, RefusesWhatIsNoNumber) {
    EXPECT_EQ(problemText("1 + 2x"), "expr-E01 '2x': '2x': this is neither a number nor a name");
    EXPECT_EQ(problemText("1e999"), "expr-E01 '1e999': '1e999': the number is too large");
    EXPECT_EQ(problemText("1" + std::string(400, '0')).substr(0, 8), "expr-E01");
    EXPECT_EQ(problemText("0x40000000000000"),
              "expr-E01 '0x40000000000000': '0x40000000000000': a hexadecimal number is at most 2^53");
}

TEST(ExpressionSyntax, DividesNumbersWithoutCuttingThem) {
    EXPECT_EQ(numberOf("1/2"), .5);
    EXPECT_EQ(numberOf("7 % 3"), 1);
    EXPECT_EQ(numberOf("-7 % 3"), 2) << "mod has the sign of the divisor";
    EXPECT_EQ(numberOf("5.5 % -2"), -.5);
}

/// GLSL 4.60, section 5.1, stated a second time: operators by rising precedence.
const std::vector<std::vector<std::string>> kLevels{
    {"||"},       {"^^"},     {"&&"},         {"|"}, {"^"}, {"&"}, {"==", "!="}, {"<", ">", "<=", ">="},
    {"<<", ">>"}, {"+", "-"}, {"*", "/", "%"}};

/// True if a text can be evaluated; then `value` is its value.
bool evaluates(const std::string& text, double& value) {
    static const NameTable table;
    const auto expression = parse(text, {}, table);
    if (!expression) return false;
    const auto result = expression->evaluate(table);
    if (result) value = result->number();
    return static_cast<bool>(result);
}

TEST(ExpressionSyntax, BindsEveryPairOfOperatorsAsGlslDoes) {
    // Types decide which of the two readings of "x A y B z" is valid where A or B takes bools; where both
    // are, the values of several operands decide.
    const std::vector<std::string> operands{"7", "2", "3", "0", "1", "true", "false"};
    int differing = 0;
    for (std::size_t first = 0; first < kLevels.size(); ++first)
        for (std::size_t second = 0; second < kLevels.size(); ++second)
            for (const std::string& a : kLevels[first])
                for (const std::string& b : kLevels[second])
                    for (const std::string& x : operands)
                        for (const std::string& y : operands)
                            for (const std::string& z : operands) {
                                const std::string left = "(" + x + a + " " + y + ")" + b + " " + z;
                                const std::string right = x + a + " " + "(" + y + b + " " + z + ")";
                                double plain = 0, asLeft = 0, asRight = 0;
                                const bool plainGood = evaluates(x + a + " " + y + b + " " + z, plain);
                                const bool leftGood = evaluates(left, asLeft);
                                const bool rightGood = evaluates(right, asRight);
                                const bool bindsLeft = first >= second;
                                ASSERT_EQ(plainGood, bindsLeft ? leftGood : rightGood) << left;
                                if (plainGood) {
                                    ASSERT_EQ(plain, bindsLeft ? asLeft : asRight) << left;
                                }
                                differing += leftGood != rightGood || asLeft != asRight ? 1 : 0;
                            }
    EXPECT_GT(differing, 1000) << "most readings must differ, or the test says nothing";
}

TEST(ExpressionSyntax, ConditionsBindLastAndFromTheRight) {
    EXPECT_EQ(numberOf("yes ? 1 : yes ? 2 : 3"), 1);
    EXPECT_EQ(numberOf("no ? 1 : no ? 2 : 3"), 3);
    EXPECT_EQ(numberOf("yes ? no ? 1 : 2 : 3"), 2);
    EXPECT_EQ(numberOf("1 + (a > b || yes ? 4 : 5)"), 5);
    EXPECT_EQ(numberOf("- a - - b"), 1);
    EXPECT_EQ(numberOf("-a*b"), -6);
    EXPECT_EQ(numberOf("~5"), -6);
    EXPECT_FALSE(valueOf("!yes && no").truth());
}

TEST(ExpressionSyntax, OnlyTheBranchThatIsTakenIsEvaluated) {
    EXPECT_EQ(numberOf("a > 0 ? a : 1 / (a - a)"), 2);
    EXPECT_EQ(numberOf("true ? a : 1 / 0"), 2);
    EXPECT_EQ(numberOf("false ? 1 / 0 : a"), 2);
    EXPECT_FALSE(valueOf("no && 1 / (a - a) > 0").truth());
    EXPECT_TRUE(valueOf("yes || 1 / (a - a) > 0").truth());
    EXPECT_FALSE(valueOf("false && 1 / (a - a) > 0").truth());
    EXPECT_TRUE(valueOf("true && yes").truth());
    EXPECT_TRUE(valueOf("yes ^^ no").truth());
}

TEST(ExpressionSyntax, SelectsComponentsAndElements) {
    EXPECT_EQ(numberOf("v.z"), 3);
    EXPECT_EQ(numberOf("w.wzyx.x"), 4);
    EXPECT_EQ(numberOf("v.rgb.b + w.stpq.q"), 7);
    EXPECT_EQ(numberOf("a.x"), 2);
    EXPECT_EQ(valueOf("a.xxx").vec3(), glm::dvec3(2));
    EXPECT_EQ(numberOf("v[a]"), 3);
    EXPECT_EQ(numberOf("v[1.9]"), 2) << "cut toward zero";
    EXPECT_EQ(numberOf("m3[2][1]"), 1);
    EXPECT_EQ(numberOf("m4[3].y"), 6);
    EXPECT_EQ(valueOf("m3[b - 2]").vec3(), glm::dvec3(1, 3, 0));
    EXPECT_EQ(numberOf("vec3(1, 2, 3)[2]"), 3);
    EXPECT_EQ(numberOf("(v * 2).y"), 4);
}

TEST(ExpressionSyntax, SkipsBlanksCommentsAndJoinedLines) {
    EXPECT_EQ(numberOf(" \t( a\xc2\xa0+ \\\n b ) "), 5);
    EXPECT_EQ(numberOf("a + \\ # two\r\n b"), 5);
    EXPECT_EQ(numberOf("a // + b"), 2);
    EXPECT_EQ(numberOf("a # + b"), 2);
}

TEST(ExpressionSyntax, ReportsTheFirstMistakeWithItsPlace) {
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "expr-E01 '': the expression is empty"},
        {"  # nothing", "expr-E01 '  # nothing': the expression is empty"},
        {"a +", "expr-E01 '': expected a value, found the end of the expression"},
        {"a + * b", "expr-E01 '*': expected a value, found '*'"},
        {"[1 2 3][a]",
         "expr-E01 '[': expected a value, found '['; write vec3(1, 2, 3), or give a longer list a name: 'Let "
         "a [5 3 1 2 4]'"},
        {"(a + b", "expr-E01 '': expected ')', found the end of the expression"},
        {"a b", "expr-E01 'b': expected an operator or the end of the expression, found 'b'"},
        {"a)", "expr-E01 ')': expected an operator or the end of the expression, found ')'"},
        {"min(a b)", "expr-E01 'b': expected ',' or ')', found 'b'"},
        {"v[1", "expr-E01 '': expected ']', found the end of the expression"},
        {"yes ? 1",
         "expr-E01 '': expected ':' and the value for the other case, found the end of the expression"},
        {"a = b", "expr-E01 '=': '=': nothing can be assigned here; '==' compares"},
        {"a \xe2\x88\x92 b",
         "expr-E01 '\xe2\x88\x92': '\xe2\x88\x92': this character is not part of the syntax of expressions"},
        {"a \\ b", "expr-E01 '\\': '\\': this character is not part of the syntax of expressions"},
        {"v.", "expr-E01 '': expected the name of a field or component, found the end of the expression"},
        {"(a).5", "expr-E01 '.5': expected an operator or the end of the expression, found '.5'"},
        {"sin + 1", "expr-E01 'sin': 'sin' is a function; its arguments follow in parentheses"},
    };
    for (const auto& [text, expected] : cases) EXPECT_EQ(problemText(text), expected) << text;
}

TEST(ExpressionSyntax, PlacesCountFromTheOrigin) {
    const auto problem = [](std::string_view text) {
        return parse(text, {"scene.glib", 7, 12}, sceneTable()).problem.message.place;
    };
    EXPECT_EQ(problem("a + nothing"), (Place{"scene.glib", 7, 16}));
    EXPECT_EQ(problem("a \\\n + nothing"), (Place{"scene.glib", 8, 4}));
    EXPECT_EQ(problem("a \\\r\n + nothing"), (Place{"scene.glib", 8, 4}));
    EXPECT_EQ(problem("a \\\r + nothing"), (Place{"scene.glib", 8, 4}));
}

TEST(ExpressionSyntax, EqualTextsWithEqualNamesAreEqual) {
    EXPECT_EQ(parsed("a + b"), parsed("a + b"));
    EXPECT_FALSE(parsed("a + b") == parsed("b + a"));
    NameTable other = sceneTable();
    other.add("a", Type::number(), Depends::variable);
    EXPECT_FALSE(*parse("a + b", {}, other) == parsed("a + b")) << "another slot";
    EXPECT_EQ(*parse("a + b", {"x", 3, 4}, sceneTable()), parsed("a + b")) << "places do not count";
    EXPECT_EQ(parsed(" a+b ").text(), " a+b ");
}

TEST(ExpressionSyntax, ComputesConstantsOnce) {
    const NameTable nothing;
    for (const char* text :
         {"2 * (3 + 4)", "sin(pi / 6) + .5", "true ? 1 : 0", "vec3(1, 2, 3).y", "mat3(2)[1][1]"}) {
        const auto expression = parse(text, {}, nothing);
        ASSERT_TRUE(expression) << text;
        EXPECT_TRUE(expression->constant()) << text;
        EXPECT_EQ(expression->constant(), *expression->evaluate(nothing)) << text;
    }
    EXPECT_FALSE(parsed("a").constant());
    EXPECT_TRUE(parsed("true ? 1 : a").constant()) << "the other branch is never taken";
    EXPECT_FALSE(parsed("1 / 0").constant()) << "no value";
}

}  // namespace
}  // namespace glibra::expression::test
