#include "plan/overrides.h"

#include <gtest/gtest.h>

#include "by_hand.h"
#include "plan/uniforms.h"

namespace glibra::plan {
namespace {

using glib::UniformForm;
using test::ids;
using test::textOf;
using test::Values;

void expectOverride(const char* text, const char* name, UniformForm form, const Values& values) {
    const Result<Override> read = parseOverride(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read->name, name) << text;
    EXPECT_EQ(read->form, form) << text;
    EXPECT_EQ(read->values, values) << text;
}

TEST(OverrideText, HoldsANumber) {
    expectOverride("uKd=.5", "uKd", UniformForm::number, {.5});
    expectOverride("uKd=-1e-3", "uKd", UniformForm::number, {-1e-3});
    expectOverride("uKd=+5.", "uKd", UniformForm::number, {5});
    expectOverride(" uKd = 2 ", "uKd", UniformForm::number, {2});
}
TEST(OverrideText, HoldsNumbersBetweenCommasOrBlanks) {
    expectOverride("uColor=1,.5,0", "uColor", UniformForm::list, {1, .5, 0});
    expectOverride("uColor=1 .5\t0", "uColor", UniformForm::list, {1, .5, 0});
    expectOverride("uColor=1, .5, 0", "uColor", UniformForm::list, {1, .5, 0});
}
TEST(OverrideText, HoldsBrackets) {
    expectOverride("uM=[1 0 0 1]", "uM", UniformForm::list, {1, 0, 0, 1});
    expectOverride("uA=[4]", "uA", UniformForm::list, {4});
    expectOverride("uC={1 .5 0}", "uC", UniformForm::color, {1, .5, 0});
    expectOverride("uR=<0 1 2>", "uR", UniformForm::range, {0, 1, 2});
}
TEST(OverrideText, HoldsASwitch) {
    expectOverride("uOn=true", "uOn", UniformForm::truth, {1});
    expectOverride("uOn=<false>", "uOn", UniformForm::truth, {0});
}
TEST(OverrideText, HoldsAWordOfAChoice) {
    expectOverride("method=front_only2", "method", UniformForm::number, {});
    EXPECT_EQ(parseOverride("method= front_only2 ")->word, "front_only2");
    EXPECT_EQ(parseOverride("method=1")->word, "");
}
TEST(OverrideText, IsRejectedIfItIsMalformed) {
    for (const char* text : {"uKd", "=5", "uKd=", "uKd=1,x", "uKd=[five]", "uKd=[1", "uKd=[]", "uKd=inf",
                             "uKd=nan", "uKd=1e99", "uKd=0x10", "uKd=1.5f", "uKd=[", ""})
        EXPECT_FALSE(parseOverride(text)) << text;
    EXPECT_FALSE(parseOverride("uKd=" + std::string(20000, '1')));
    std::string many = "uKd=";
    for (int i = 0; i < 5000; ++i) many += "1,";
    EXPECT_FALSE(parseOverride(many));
}

TEST(OverrideText, NeedsANumberBesideEachCommaAndOneSign) {
    for (const char* text : {"uV=1,,0,1", "uV=,1,0,1", "uV=1,0,1,", "uV=,1,0,1,", "uV=1, ,0", "uV=,",
                             "uV=[1,,0]", "uV={,1 0 0}", "uV=<0 1 2,>", "uV=1 ,, 0", "uK=+-.5", "uK=-+.5",
                             "uK=++1", "uK=--1", "uK=1,+-2", "uK=.", "uK=-", "uK=1e", "uK=1.2.3"})
        EXPECT_FALSE(parseOverride(text)) << text;
    expectOverride("uV=1 , 0 ,1", "uV", UniformForm::list, {1, 0, 1});
    EXPECT_NE(parseOverride("uV=1,,0").diagnostics.front().text.find("a number is missing"),
              std::string::npos);
}
TEST(OverrideText, SaysThatANumberIsTooLarge) {
    for (const char* text : {"x=1e39", "x=-1e39", "x=1e999", "x=1,2,4e38"})
        EXPECT_NE(parseOverride(text).diagnostics.front().text.find("is too large for a 32-bit float"),
                  std::string::npos)
            << text;
    expectOverride("x=3.4e38", "x", UniformForm::number, {3.4e38});
    expectOverride("x=1e-999", "x", UniformForm::number, {0});
}

scene::Program dots(std::vector<glib::UniformSpec> pairs) {
    scene::Program program;
    program.name = "Dots";
    program.uniforms = std::move(pairs);
    return program;
}
struct Outcome {
    UniformResolution resolution;
    std::vector<bool> used;
};
Outcome outcomeOf(const ProgramInterface& interface, std::vector<glib::UniformSpec> pairs,
                  const std::vector<Override>& overrides) {
    Outcome outcome;
    outcome.resolution =
        resolveUniforms(dots(std::move(pairs)), test::kScenePath, interface, overrides, outcome.used);
    return outcome;
}

TEST(Overriding, ReplacesTheScenesValue) {
    const Outcome outcome = outcomeOf(test::interfaceWith({{"uKd", "float"}}), {test::number("uKd", .1)},
                                      {{"uKd", UniformForm::number, {.9}}});
    ASSERT_EQ(outcome.resolution.values.size(), 1U);
    EXPECT_EQ(std::get<Literal>(outcome.resolution.values[0].value).values, Values{.9});
    EXPECT_TRUE(outcome.used.at(0));
}
TEST(Overriding, IsForOneProgramIfItNamesOne) {
    const auto isUsed = [](const std::string& text) {
        const Result<Override> read = parseOverride(text);
        const Outcome outcome = outcomeOf(test::interfaceWith({{"uKd", "float"}}), {}, {*read});
        return outcome.used.at(0) && outcome.resolution.values.size() == 1;
    };
    EXPECT_TRUE(isUsed("uKd=.9"));
    EXPECT_TRUE(isUsed(dots({}).name + ":uKd=.9"));
    EXPECT_TRUE(isUsed(std::to_string(dots({}).place.line) + " : uKd=.9"));
    EXPECT_FALSE(isUsed("Other:uKd=.9"));
    EXPECT_FALSE(isUsed(std::to_string(dots({}).place.line + 1) + ":uKd=.9"));
}
TEST(Overriding, SetsWhatTheSceneDoesNot) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"uKd", "float"}}), {}, {{"uKd", UniformForm::number, {.9}}});
    EXPECT_EQ(outcome.resolution.values.size(), 1U);
    EXPECT_EQ(ids(outcome.resolution.diagnostics), "");
}
TEST(Overriding, KeepsTheSliderAndMovesIt) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"uKd", "float"}}),
                  {test::spec("uKd", UniformForm::range, {0, .5, 2})}, {{"uKd", UniformForm::number, {1.5}}});
    ASSERT_EQ(outcome.resolution.controls.size(), 1U);
    EXPECT_EQ(outcome.resolution.controls[0].maximum, 2);
    EXPECT_EQ(outcome.resolution.controls[0].current, 1.5);
}
TEST(Overriding, WithAnUnsuitableValueKeepsTheScenesValue) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"uM", "mat2"}}), {test::spec("uM", UniformForm::list, {1, 2, 3, 4})},
                  {{"uM", UniformForm::truth, {1}}});
    ASSERT_EQ(outcome.resolution.values.size(), 1U);
    EXPECT_EQ(std::get<Literal>(outcome.resolution.values[0].value).values, (Values{1, 2, 3, 4}));
    EXPECT_EQ(ids(outcome.resolution.diagnostics), "glib-W20");
}
TEST(Overriding, SelectsTheUnitOfASampler) {
    const Outcome outcome = outcomeOf(test::interfaceWith({{"uTex", "sampler2D"}}), {test::number("uTex", 5)},
                                      {{"uTex", UniformForm::number, {8}}});
    EXPECT_EQ(outcome.resolution.samplers.at(0).unit, 8);
}
TEST(Overriding, OfASuppliedNameHasNoEffect) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"Timer", "float"}}), {}, {{"Timer", UniformForm::number, {.5}}});
    EXPECT_EQ(ids(outcome.resolution.diagnostics), "glib-W25");
    EXPECT_TRUE(outcome.used.at(0));
}
TEST(Overriding, TheLastOfTheSameNameCounts) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"uKd", "float"}}), {},
                  {{"uKd", UniformForm::number, {.1}}, {"uKd", UniformForm::number, {.2}}});
    EXPECT_EQ(std::get<Literal>(outcome.resolution.values.back().value).values, Values{.2});
}
TEST(Overriding, OfAnUnknownNameIsUnused) {
    const Outcome outcome =
        outcomeOf(test::interfaceWith({{"uKd", "float"}}), {}, {{"uKe", UniformForm::number, {.1}}});
    EXPECT_FALSE(outcome.used.at(0));
}
TEST(UnusedOverride, IsReportedWithANearName) {
    const std::vector<Override> overrides{{"ushrink", UniformForm::number, {1}},
                                          {"uKd", UniformForm::number, {1}}};
    const std::vector<std::string> names{"uShrink", "uKd"};
    const Diagnostics diagnostics = unusedOverrides(overrides, {false, true}, names);
    EXPECT_EQ(textOf(diagnostics, "glib-W23"),
              "no program of the scene has a uniform 'ushrink'; did you mean 'uShrink'?");
    EXPECT_TRUE(diagnostics.front().place.file.empty());
}
TEST(UnusedOverride, ThatIsAWordIsAnError) {
    const std::vector<Override> overrides{*parseOverride("uKd=five").value,
                                          *parseOverride("Dots:uKd=five").value};
    const Diagnostics diagnostics = unusedOverrides(overrides, {false, false}, {});
    ASSERT_EQ(diagnostics.size(), 2U);
    EXPECT_EQ(diagnostics[0].text,
              "--set uKd=five: 'five' is not a number, and the scene has no choice 'uKd' with words");
    EXPECT_EQ(
        diagnostics[1].text,
        "--set Dots:uKd=five: 'five' is not a number, and program 'Dots' has no subroutine uniform 'uKd'");
    EXPECT_TRUE(hasError(diagnostics));
}
TEST(UnusedOverride, OfOneProgramNamesThatProgram) {
    const std::vector<Override> overrides{{"uKd", UniformForm::number, {1}, "Dost"}};
    const std::vector<std::string> names{"uKd"};
    EXPECT_EQ(textOf(unusedOverrides(overrides, {false}, names), "glib-W23"),
              "no program 'Dost' has a uniform 'uKd'");
}

}  // namespace
}  // namespace glibra::plan
