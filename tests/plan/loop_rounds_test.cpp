// Loops that the driver would end: the warning, and when the driver's limit is requested.

#include "plan/loop_rounds.h"

#include <gtest/gtest.h>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using glsl::CountedLoop;
using test::textOf;

/// The loop for (i = 0; i < bound; ++i).
CountedLoop loopTo(std::variant<double, std::string, glsl::Operation> bound,
                   std::vector<CountedLoop> inside = {}) {
    CountedLoop loop;
    loop.place = {"a.frag", 7, 3};
    loop.first = {{0.}};
    loop.bound = {{std::move(bound)}};
    loop.step = {{1.}};
    loop.inside = std::move(inside);
    return loop;
}

struct LoopCase {
    ProgramInterface interface = test::interfaceWith({{"uN", "int"}});
    PlannedProgram program;
    int asked = 0;

    Diagnostics report(std::vector<CountedLoop> loops, int limit = 65'535) {
        interface.facts.stages.resize(1);
        interface.facts.stages[0].loops = std::move(loops);
        program.interface = &interface;
        return reportLongLoops(program, [&] {
            ++asked;
            return limit;
        });
    }
};

TEST(LongLoop, IsReportedWithItsRoundsAndItsPlace) {
    LoopCase one;
    one.program.values.push_back({UniformIndex(0), 0, Literal{{100'000}}});
    const Diagnostics said = one.report({loopTo("uN")});
    EXPECT_EQ(textOf(said, "draw-W08"),
              "this loop runs up to 100,000 rounds, but the driver ends a shader's loops after 65,535; the "
              "picture may be wrong");
    EXPECT_EQ(said.at(0).place.line, 7);
    EXPECT_EQ(said.at(0).place.file, "a.frag");
}
TEST(LongLoop, CountsTheLoopsInsideIt) {
    EXPECT_EQ(textOf(LoopCase().report({loopTo(300., {loopTo(300.)})}), "draw-W08"),
              "this loop and those in it run up to 90,300 rounds, but the driver ends a shader's loops after "
              "65,535; the picture may be wrong");
}
TEST(LongLoop, MayBeSeveralInARow) {
    EXPECT_EQ(textOf(LoopCase().report({loopTo(40'000.), loopTo(30'000.)}), "draw-W08"),
              "the loops of this stage run up to 70,000 rounds, but the driver ends a shader's loops after "
              "65,535; the picture may be wrong");
}
TEST(LongLoop, IsNotReportedIfTheDriverLetsItRun) {
    LoopCase one;
    EXPECT_TRUE(one.report({loopTo(1e6)}, 0).empty());
    EXPECT_EQ(one.asked, 1);
}
TEST(LongLoop, TheDriverIsNotAskedAboutShortOnes) {
    LoopCase one;
    EXPECT_TRUE(one.report({loopTo(30'000.)}).empty());
    EXPECT_EQ(one.asked, 0);
}
TEST(LongLoop, OfAnUnsetUniformHasNoRounds) {
    EXPECT_TRUE(LoopCase().report({loopTo("uN")}).empty());
}
TEST(LongLoop, OfAnInitialisedUniformIsNotKnown) {
    LoopCase one;
    one.interface.facts.uniforms["uN"] = {{}, true};
    EXPECT_TRUE(one.report({loopTo("uN", {loopTo(1e6)})}).size() == 1U) << "the inner one is";
    EXPECT_TRUE(one.report({loopTo("uN")}).empty());
}
TEST(LongLoop, OfAUniformThatTheRuntimeSuppliesIsNotKnown) {
    LoopCase one;
    one.program.values.push_back({UniformIndex(0), 0, Supplied{glsl::Builtin::timer}});
    EXPECT_TRUE(one.report({loopTo("uN")}).empty());
}

}  // namespace
}  // namespace glibra::plan
