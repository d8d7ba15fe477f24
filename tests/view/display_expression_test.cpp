// What an expression of GLSL makes of each texel.

#include "view/debug_view/display_expression.h"

#include <string>
#include <vector>

#include <cmath>

#include "scene_folder.h"

namespace glibra::test {
namespace {

TEST(DisplayExpression, ComputesTexels) {
    render::Content content;
    content.width = 3;
    content.height = 2;
    content.components = 2;
    content.values = {0, 1, .25, 2, .5, 3, 10, 4, 20, 5, 30, 6};
    const auto shown = [&](const std::string& expression, std::size_t texel) {
        const view::Displayed made = view::displayedBy(context(), content, expression);
        EXPECT_EQ(made.problem, "");
        if (!made.content) return std::vector<double>();
        EXPECT_EQ(made.content->width, 3);
        EXPECT_EQ(made.content->height, 2);
        const auto values = made.content->at(texel);
        return std::vector<double>(values.begin(), values.end());
    };
    EXPECT_EQ(shown("color", 1), (std::vector<double>{.25, 2, 0, 1}));
    EXPECT_EQ(shown("color.gr", 4), (std::vector<double>{5, 20, 0, 1}));
    EXPECT_EQ(shown("10. * color.r", 2), (std::vector<double>{5, 5, 5, 1}));
    EXPECT_EQ(shown("near(1, 0).r - color.r", 3), (std::vector<double>{10, 10, 10, 1}));
    EXPECT_EQ(shown("near(1, 1).g", 5), (std::vector<double>{6, 6, 6, 1})) << "no texel beyond the edge";
    EXPECT_NEAR(shown("vec3(st, size.x)", 3).at(0), 1. / 6, 1e-6);
    EXPECT_NEAR(shown("vec3(st, size.x)", 3).at(1), .75, 1e-6);
    EXPECT_EQ(shown("vec3(st, size.x)", 3).at(2), 3);
    // A division by 0 is that of IEEE 754, whether the driver sees a constant or not.
    for (const char* zero : {"0.", ".0", "0.e0", "(1. - 1.)", "vec4(0.)", "(color.r - color.r)"}) {
        const std::vector<double> quotient = shown(std::string("color / ") + zero, 1);
        ASSERT_EQ(quotient.size(), 4U);
        EXPECT_TRUE(std::isinf(quotient[0])) << zero << ": .25 / 0 is " << quotient[0];
        EXPECT_TRUE(std::isinf(quotient[1])) << zero;
        EXPECT_TRUE(std::isnan(quotient[2])) << zero << ": 0 / 0 is " << quotient[2];
    }
    EXPECT_EQ(shown("vec3(1.5e1, 5 / 2, 0x10)", 0), (std::vector<double>{15, 2, 16, 1}));
    EXPECT_EQ(shown("texel", 5), (std::vector<double>{2, 1, 0, 1}));
    EXPECT_EQ(shown("color.r > 1.", 0), (std::vector<double>{0, 0, 0, 1}));
}

TEST(DisplayExpression, SaysWhatIsWrong) {
    render::Content content;
    content.width = 1;
    content.values = {1, 1, 1, 1};
    const auto problem = [&](const std::string& expression) {
        const view::Displayed made = view::displayedBy(context(), content, expression);
        EXPECT_FALSE(made.content) << expression;
        return made.problem;
    };
    EXPECT_NE(problem("colour * 2."), "");
    EXPECT_NE(problem("mat3(1.)"), "");
    EXPECT_EQ(problem("1.; for (;;) ;"), "one expression, such as color.rgb * 10");
    EXPECT_EQ(problem("#define a"), "one expression, such as color.rgb * 10");
}

}  // namespace
}  // namespace glibra::test
