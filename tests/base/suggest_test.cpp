// Near names among names that all begin with the same letter.

#include "base/suggest.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace glibra::base {
namespace {

constexpr std::size_t kPrefix = 1;
const std::vector<std::string_view> kNames{"uShrink", "uTexUnit", "uKd", "uLightPosition"};

TEST(NearName, DiffersInCaseOnly) {
    EXPECT_EQ(nearestName("ushrink", kNames, kPrefix), "uShrink");
}
TEST(NearName, HasOneLetterMore) {
    EXPECT_EQ(nearestName("uTexxUnit", kNames, kPrefix), "uTexUnit");
}
TEST(NearName, HasTwoLettersExchanged) {
    EXPECT_EQ(nearestName("uShrikn", kNames, kPrefix), "uShrink");
}
TEST(NearName, MayDifferByThreeLettersInALongName) {
    EXPECT_EQ(nearestName("uLigtPositon", kNames, kPrefix), "uLightPosition");
    EXPECT_EQ(nearestName("uLightPosXXXXXX", kNames, kPrefix), "");
}
TEST(NearName, IsNotAnotherShortName) {
    EXPECT_EQ(nearestName("uKs", kNames, kPrefix), "");
}
TEST(NearName, OfSeveralIsTheNearestThenTheFirst) {
    const std::vector<std::string_view> names{"uColorBB", "uColorA", "uColorC"};
    EXPECT_EQ(nearestName("uColor", names, kPrefix), "uColorA");
}
TEST(NearName, IsNothingForEndlessNames) {
    const std::string endless(5000, 'a');
    const std::vector<std::string_view> names{endless};
    EXPECT_EQ(nearestName(endless + "b", names, kPrefix), "");
}
TEST(NearName, OfAShortNameIsOfferedWhereTheFirstLetterTells) {
    EXPECT_EQ(nearestName("uKs", kNames), "uKd");
}
TEST(NearName, IsNotTheNameItself) {
    EXPECT_EQ(nearestName("uShrink", kNames, kPrefix), "");
}
TEST(NearName, IsOfferedAsAQuestion) {
    EXPECT_EQ(suggestion("ushrink", kNames, kPrefix), "; did you mean 'uShrink'?");
    EXPECT_EQ(suggestion("volume", kNames, kPrefix), "");
}

}  // namespace
}  // namespace glibra::base
