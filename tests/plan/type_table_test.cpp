// The first table of language, 5.3: one test per row and form.
#include "plan/type_table.h"

#include <gtest/gtest.h>

#include "by_hand.h"

namespace glibra::plan {
namespace {

using glib::UniformForm;
using test::ids;
using test::readingOf;
using test::textOf;
using test::Values;

Reading scalar(const std::string& word, double value) {
    return readingOf(word, UniformForm::number, {value});
}
Reading list(const std::string& word, const Values& values) {
    return readingOf(word, UniformForm::list, values);
}
Reading range(const std::string& word, const Values& values) {
    return readingOf(word, UniformForm::range, values);
}
Reading color(const std::string& word, const Values& values) {
    return readingOf(word, UniformForm::color, values);
}
Reading truth(const std::string& word, bool value) {
    return readingOf(word, UniformForm::truth, {value ? 1.0 : 0.0});
}

void expectReading(const Reading& reading, const Values& values, const std::string& messages) {
    EXPECT_FALSE(reading.ignored);
    EXPECT_EQ(reading.values, values);
    EXPECT_EQ(ids(reading.diagnostics), messages);
}
void expectIgnored(const Reading& reading) {
    EXPECT_TRUE(reading.ignored);
    EXPECT_TRUE(reading.values.empty());
    EXPECT_EQ(ids(reading.diagnostics), "glib-W20");
}

TEST(FloatUniform, TakesANumber) {
    expectReading(scalar("float", .25), {.25}, "");
}
TEST(FloatUniform, TakesTheFirstOfAList) {
    expectReading(list("float", {2, 3}), {2}, "glib-W20");
}
TEST(FloatUniform, TakesTheCurrentOfARangeAndHasASlider) {
    const Reading reading = range("float", {.5, 1, 2});
    expectReading(reading, {1}, "");
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->form, UniformForm::range);
    EXPECT_EQ(reading.control->minimum, .5);
    EXPECT_EQ(reading.control->current, 1);
    EXPECT_EQ(reading.control->maximum, 2);
}
TEST(FloatUniform, TakesASwitchAsOneOrZero) {
    expectReading(truth("float", true), {1}, "glib-W20");
    expectReading(truth("double", false), {0}, "glib-W20");
}
TEST(FloatUniform, TakesTheFirstOfAColour) {
    expectReading(color("double", {.5, 1, 0}), {.5}, "glib-W20");
}

TEST(FloatUniform, RefusesWhatNoFloatHolds) {
    for (const char* word : {"float", "vec3", "mat4"})
        for (const double value : {1e39, -1e300})
            for (const Reading& each :
                 {scalar(word, value), list(word, {0, value}), range(word, {0, value, 2})}) {
                if (!each.values.empty() && each.values.front() == 0 && !each.ignored)
                    continue;  // a list's first
                EXPECT_TRUE(each.ignored) << word;
                EXPECT_NE(ids(each.diagnostics).find("glib-E31"), std::string::npos) << word;
            }
    expectReading(scalar("double", 1e300), {1e300}, "");
    expectReading(scalar("float", 3.4e38), {3.4e38}, "");
}

TEST(IntUniform, TakesTheWholeNumberThatRoundingErrorsMissed) {
    expectReading(scalar("int", .6 / .1), {6}, "");
    expectReading(scalar("uint", .29 * 100), {29}, "");
}

TEST(IntUniform, CutsANumberTowardZero) {
    expectReading(scalar("int", 10.5), {10}, "glib-W27");
    expectReading(scalar("int", -2.75), {-2}, "glib-W27");
    EXPECT_EQ(textOf(scalar("int", 10.5).diagnostics, "glib-W27"), "10.5 is cut to 10");
    expectReading(scalar("int", 4), {4}, "");
}
TEST(IntUniform, TakesTheFirstOfAListCut) {
    expectReading(list("int", {2.5, 3}), {2}, "glib-W20 glib-W27");
}
TEST(IntUniform, HasASliderOfIntegers) {
    const Reading reading = range("int", {0, 2.5, 9.5});
    expectReading(reading, {2}, "glib-W27");
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->current, 2);
    EXPECT_EQ(reading.control->maximum, 9);
}
TEST(IntUniform, TakesASwitchWithoutWarning) {
    expectReading(truth("int", true), {1}, "");
    expectReading(truth("uint", false), {0}, "");
}
TEST(IntUniform, TakesTheFirstOfAColour) {
    expectReading(color("int", {1, 0, 0}), {1}, "glib-W20");
}
TEST(IntUniform, IsLimitedToThirtyTwoBits) {
    expectReading(scalar("int", 1e30), {2147483647}, "glib-W20");
    expectReading(scalar("uint", 1e30), {4294967295}, "glib-W20");
}
TEST(UintUniform, TakesANegativeNumberAsZero) {
    expectReading(scalar("uint", -3), {0}, "glib-W20");
    EXPECT_EQ(textOf(scalar("uint", -3).diagnostics, "glib-W20"), "uA is uint, so -3 is read as 0");
}

TEST(BoolUniform, IsWhetherANumberIsNotZero) {
    expectReading(scalar("bool", .5), {1}, "");
    expectReading(scalar("bool", 0), {0}, "");
}
TEST(BoolUniform, TakesTheFirstOfAList) {
    expectReading(list("bool", {2, 0}), {1}, "glib-W20");
}
TEST(BoolUniform, TakesTheCurrentOfARangeAndHasACheckBox) {
    const Reading reading = range("bool", {0, 0, 1});
    expectReading(reading, {0}, "glib-W20");
    EXPECT_EQ(textOf(reading.diagnostics, "glib-W20"), "uA is bool, so range < 0 0 1 > is read as false");
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->form, UniformForm::truth);
}
TEST(BoolUniform, TakesASwitchAndHasACheckBox) {
    const Reading reading = truth("bool", true);
    expectReading(reading, {1}, "");
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->form, UniformForm::truth);
    EXPECT_EQ(reading.control->current, 1);
}
TEST(BoolUniform, TakesTheFirstOfAColourWithAWarning) {
    expectReading(color("bool", {0, 1, 1}), {0}, "glib-W20");
}

TEST(VectorUniform, SpreadsANumberOverAllComponents) {
    expectReading(scalar("vec3", .5), {.5, .5, .5}, "glib-W20");
    expectReading(scalar("bvec2", 7), {1, 1}, "glib-W20");
    expectReading(scalar("ivec3", 2), {2, 2, 2}, "glib-W20");
}
TEST(VectorUniform, TakesTheComponentsOfAList) {
    expectReading(list("vec3", {1, 2, 3}), {1, 2, 3}, "");
    expectReading(list("bvec2", {0, 3}), {0, 1}, "");
    expectReading(list("ivec3", {1, 2.5, 3.5}), {1, 2, 3}, "glib-W27");
    expectReading(list("uvec2", {1, -1}), {1, 0}, "glib-W20");
}
TEST(VectorUniform, SpreadsTheCurrentOfARange) {
    expectReading(range("vec2", {0, .5, 1}), {.5, .5}, "glib-W20");
}
TEST(VectorUniform, SpreadsASwitch) {
    expectReading(truth("vec4", true), {1, 1, 1, 1}, "glib-W20");
}
TEST(VectorUniform, OfThreeOrFourFloatsTakesAColour) {
    const Reading reading = color("vec3", {1, .5, 0});
    expectReading(reading, {1, .5, 0}, "");
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->form, UniformForm::color);
    expectReading(color("vec4", {1, .5, 0, .25}), {1, .5, 0, .25}, "");
}
TEST(VectorUniform, OfAnotherKindTakesAColourWithAWarning) {
    expectReading(color("vec2", {1, .5, 0}), {1, .5}, "glib-W20");
    expectReading(color("dvec3", {1, .5, 0}), {1, .5, 0}, "glib-W20");
    expectReading(color("bvec2", {1, 0, 0}), {1, 0}, "glib-W20");
}

TEST(MatrixUniform, PutsANumberOnTheDiagonal) {
    expectReading(scalar("mat2", 3), {3, 0, 0, 3}, "glib-W20");
    expectReading(scalar("mat2x3", 3), {3, 0, 0, 0, 3, 0}, "glib-W20");
}
TEST(MatrixUniform, TakesColumns) {
    expectReading(list("mat2x3", {1, 2, 3, 4, 5, 6}), {1, 2, 3, 4, 5, 6}, "");
}
TEST(MatrixUniform, PutsTheCurrentOfARangeOnTheDiagonal) {
    expectReading(range("mat2", {0, 2, 4}), {2, 0, 0, 2}, "glib-W20");
}
TEST(MatrixUniform, IgnoresASwitch) {
    expectIgnored(truth("mat3", true));
}
TEST(MatrixUniform, IgnoresAColour) {
    expectIgnored(color("mat4", {1, 0, 0}));
}

TEST(ArrayUniform, TakesANumberAsItsFirstElement) {
    expectReading(scalar("float[4]", 2), {2}, "glib-W20");
}
TEST(ArrayUniform, TakesAListAsAllItsElements) {
    expectReading(list("float[3]", {1, 2, 3}), {1, 2, 3}, "");
    expectReading(list("vec2[2]", {1, 2, 3, 4}), {1, 2, 3, 4}, "");
}
TEST(ArrayUniform, TakesTheOtherFormsAsItsFirstElement) {
    expectReading(range("float[4]", {0, 2, 4}), {2}, "glib-W20");
    expectReading(truth("int[4]", true), {1}, "glib-W20");
    expectReading(color("vec3[2]", {1, .5, 0}), {1, .5, 0}, "glib-W20");
    EXPECT_FALSE(range("float[4]", {0, 2, 4}).control);
}
TEST(ArrayUniform, IgnoresWhatItsElementsIgnore) {
    expectIgnored(truth("mat2[2]", true));
    expectIgnored(color("sampler2D[2]", {1, 0, 0}));
}
TEST(ArrayUniform, TakesAValueForTheElementThatTheTagNames) {
    const Values values{5};
    const Reading reading =
        readValue({"uA[2]", UniformForm::number, values, {}, {}}, test::uniform("uA", "float[4]"), true);
    expectReading(reading, {5}, "");
}

TEST(SamplerUniform, TakesItsUnit) {
    expectReading(scalar("sampler2D", 5), {5}, "");
    expectReading(scalar("image2D", 127), {127}, "");
}
TEST(SamplerUniform, TakesTheFirstOfAList) {
    expectReading(list("sampler2D", {5, 6}), {5}, "glib-W20");
}
TEST(SamplerUniform, TakesTheCurrentOfARange) {
    expectReading(range("sampler3D", {0, 6, 9}), {6}, "glib-W20");
}
TEST(SamplerUniform, IgnoresASwitch) {
    expectIgnored(truth("samplerCube", true));
}
TEST(SamplerUniform, IgnoresAColour) {
    expectIgnored(color("sampler2D", {1, 0, 0}));
}
TEST(SamplerUniform, HasUnitsOfAListInAnArray) {
    expectReading(list("sampler2D[2]", {5, 6}), {5, 6}, "");
}
TEST(SamplerUniform, RejectsNumbersThatAreNotUnits) {
    for (const double unit : {128.0, -1.0, 1e30}) {
        const Reading reading = scalar("sampler2D", unit);
        EXPECT_TRUE(reading.ignored);
        EXPECT_EQ(ids(reading.diagnostics), "glib-E12");
    }
    EXPECT_EQ(textOf(scalar("sampler2D", 200).diagnostics, "glib-E12"),
              "texture unit 200 is not between 0 and 127");
}

TEST(OpaqueUniform, OfAnotherKindIgnoresEverything) {
    expectIgnored(scalar("atomic_uint", 1));
    expectIgnored(list("atomic_uint[2]", {1, 2}));
}

TEST(NumberText, LeavesOutTheZeroBeforeThePoint) {
    EXPECT_EQ(numberText(.1), ".1");
    EXPECT_EQ(numberText(-.25), "-.25");
    EXPECT_EQ(numberText(0), "0");
    EXPECT_EQ(numberText(10), "10");
    EXPECT_EQ(numberText(1.5), "1.5");
}

}  // namespace
}  // namespace glibra::plan
