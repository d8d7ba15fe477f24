// Which parentheses of a classic statement hold an expression.

#include "expression/parentheses.h"

#include <gtest/gtest.h>

namespace glibra::expression::test {
namespace {

TEST(ExpressionParentheses, EndWithTheirPartner) {
    EXPECT_EQ(partnerOf("(a (b) c) d)", 0), 8U);
    EXPECT_EQ(partnerOf("(a (b) c) d)", 3), 5U);
    EXPECT_EQ(partnerOf("(a # )\n b)", 0), 9U);
    EXPECT_EQ(partnerOf("(a // )", 0), std::string_view::npos);
    EXPECT_EQ(partnerOf("(a", 0), std::string_view::npos);
}

}  // namespace
}  // namespace glibra::expression::test
