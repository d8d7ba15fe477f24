#include "view/scene/slider_scale.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <utility>

namespace glibra::test {
namespace {

TEST(TypedNumber, IsAnExpressionWithAPointOrAComma) {
    for (const auto& [text, number] :
         std::initializer_list<std::pair<const char*, double>>{{"0.5", .5},
                                                               {".5", .5},
                                                               {"0,5", .5},
                                                               {",5", .5},
                                                               {"-0,25", -.25},
                                                               {"1e-3", 1e-3},
                                                               {"7", 7},
                                                               {"1/3", 1. / 3},
                                                               {"2*.3", .6},
                                                               {"2*0,3", .6},
                                                               {" 4 + 1 ", 5},
                                                               {"(1+2)*3", 9},
                                                               {"sqrt(16)", 4},
                                                               {"max(1, 2)", 2},
                                                               {"max(0,5)", 5},
                                                               {"-3", -3},
                                                               {"20000", 20000}}) {
        const std::optional<double> typed = view::typedNumber(text);
        ASSERT_TRUE(typed) << text;
        EXPECT_DOUBLE_EQ(*typed, number) << text;
    }
}

TEST(TypedNumber, IsNothingForOtherTexts) {
    for (const char* text : {"", "abc", "1,2,3", "1 2", "1/", "1/0", "vec3(1)", "true", "time", "1e999",
                             "1e39", "-1e39", "0.5.5"})
        EXPECT_FALSE(view::typedNumber(text)) << text;
}

}  // namespace
}  // namespace glibra::test
