// Which parentheses of a classic statement hold an expression.

#include "expression/parentheses.h"

#include <gtest/gtest.h>

namespace glibra::expression::test {
namespace {

bool isExpression(std::string_view line) {
    return beginsExpression(line, line.find('('));
}

TEST(ExpressionParentheses, HoldAnExpressionIfTheySayMoreThanNumbers) {
    for (const char* line : {"Translate (2*sin(.35*time)) 0 0",
                             "Box (size)",
                             "uA (_x)",
                             "uA (1 + 2)",
                             "uA (1 - 2)",
                             "uA (1-2)",
                             "uA (2/3)",
                             "uA (2 / 3)",
                             "uA (5 % 2)",
                             "uA (!true)",
                             "uA (1 & 2)",
                             "uA (1 | 2)",
                             "uA (1 = 2)",
                             "uA (- 1)",
                             "uA (--1)",
                             "uA (1 2 x)",
                             "uA (true ? 1 : 2) # ? is none of the signs, : neither",
                             "uA (1e3-2)",
                             "uA (vec3(1))",
                             "uA (trueish)",
                             "uA ((a))",
                             "uA (1e+x)",
                             "uA (0.5 -x)"})
        EXPECT_EQ(isExpression(line), std::string_view(line).find("? 1") == std::string_view::npos) << line;
}

TEST(ExpressionParentheses, HoldAClassicListOtherwise) {
    for (const char* line : {"uA (1 2 3)", "uA (-1 +2 -.5)", "uA (1e-3 2.E+5 1.e-7)", "uA (true)",
                             "uA (FALSE, True;)", "uA ()", "uA (1, 2, 3)", "uA (1,-2,-.3)", "uA (1. 2. 3.",
                             "uA (1 # x)", "uA (1 // x)", "uA ( ( 1 ) )", "uA (? 1)", "uA (a", "uA (1 2] x"})
        EXPECT_FALSE(isExpression(line)) << line;
}

TEST(ExpressionParentheses, EndWithTheirPartner) {
    EXPECT_EQ(partnerOf("(a (b) c) d)", 0), 8U);
    EXPECT_EQ(partnerOf("(a (b) c) d)", 3), 5U);
    EXPECT_EQ(partnerOf("(a # )\n b)", 0), 9U);
    EXPECT_EQ(partnerOf("(a // )", 0), std::string_view::npos);
    EXPECT_EQ(partnerOf("(a", 0), std::string_view::npos);
    EXPECT_FALSE(beginsExpression("(1 2) x (a", 0)) << "only what stands between the partners counts";
}

}  // namespace
}  // namespace glibra::expression::test
