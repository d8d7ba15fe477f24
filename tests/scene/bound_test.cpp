// Bound (language, 12.1): what it declares, and what is reported.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support.h"

namespace glibra::scene {
namespace {

using tests::run;
using tests::textsOf;

/// The messages of parser and interpreter.
std::string messagesOf(const std::string& text) {
    const glib::Script script = glib::parse(text, "scene.glib");
    return textsOf(script.diagnostics) + textsOf(interpret(script).diagnostics);
}

TEST(Bound, IsASliderThatKnowsItsFinestEnd) {
    const Scene scene =
        run("Bound steps <8 64 512>\nBound offset <.02 .005 .001>\nTranslate (steps) 0 0\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    ASSERT_EQ(scene.variables.size(), 2U);
    const Variable& steps = scene.variables[0];
    EXPECT_EQ(steps.written, (std::vector<double>{8, 64, 512}));
    EXPECT_EQ(steps.current, std::vector{64.});
    ASSERT_TRUE(steps.bound);
    EXPECT_EQ(steps.bound->coarsest, 8);
    EXPECT_EQ(steps.bound->finest, 512);
    EXPECT_TRUE(steps.bound->isWhole);
    const Variable& offset = scene.variables[1];
    EXPECT_EQ(offset.written, (std::vector<double>{.001, .005, .02}))
        << "a slider goes from the least number";
    ASSERT_TRUE(offset.bound);
    EXPECT_EQ(offset.bound->coarsest, .02);
    EXPECT_EQ(offset.bound->finest, .001);
    EXPECT_FALSE(offset.bound->isWhole);
    EXPECT_EQ(tests::drawsOf(scene).front().modelView[3][0], 64);
    EXPECT_FALSE(run("Let steps <8 64 512>\n").variables.front().bound);
}

TEST(Bound, RefusesWhatHasNoCheapestAndFinestValue) {
    const auto messages = [](const std::string& value) { return messagesOf("Bound steps " + value + "\n"); };
    for (const std::string value : {"<8 64>", "<8>"})  // as in Let
        EXPECT_NE(messages(value).find("needs three numbers"), std::string::npos) << messages(value);
    for (const std::string value : {"<true>", "<hard soft>", "64", "{1 2 3}", "[1 2 3]", "(64)"})
        EXPECT_NE(messages(value).find("'steps' needs <cheapest current finest>: three numbers"),
                  std::string::npos)
            << value << "\n"
            << messages(value);
    for (const std::string value : {"<0 64 512>", "<-8 4 8>", "<8 8 8>", "<8 4 -1>"})
        EXPECT_NE(messages(value).find("both ends of a Bound must be above 0, and different"),
                  std::string::npos)
            << value << "\n"
            << messages(value);
    EXPECT_NE(messages("<8 1024 512>").find("steps: current value 1024 is outside 8 ... 512"),
              std::string::npos);
    EXPECT_NE(
        messagesOf("Repeat 2\nBound steps <8 64 512>\nEndRepeat\n").find("Bound cannot stand inside Repeat"),
        std::string::npos);
}

}  // namespace
}  // namespace glibra::scene
