#include "plan/near_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace glibra::plan {
namespace {

const std::vector<std::string> kNames{"uShrink", "uTexUnit", "uKd", "uLightPosition"};

TEST(NearName, DiffersInCaseOnly) {
    EXPECT_EQ(nearestName("ushrink", kNames), "uShrink");
}
TEST(NearName, HasOneLetterMore) {
    EXPECT_EQ(nearestName("uTexxUnit", kNames), "uTexUnit");
}
TEST(NearName, HasTwoLettersExchanged) {
    EXPECT_EQ(nearestName("uShrikn", kNames), "uShrink");
}
TEST(NearName, MayDifferByThreeLettersInALongName) {
    EXPECT_EQ(nearestName("uLigtPositon", kNames), "uLightPosition");
    EXPECT_EQ(nearestName("uLightPosXXXXXX", kNames), "");
}
TEST(NearName, IsNotAnotherShortName) {
    EXPECT_EQ(nearestName("uKs", kNames), "");
}
TEST(NearName, OfSeveralIsTheNearestThenTheFirst) {
    const std::vector<std::string> names{"uColorBB", "uColorA", "uColorC"};
    EXPECT_EQ(nearestName("uColor", names), "uColorA");
}
TEST(NearName, IsNothingForEndlessNames) {
    const std::vector<std::string> names{std::string(5000, 'a')};
    EXPECT_EQ(nearestName(std::string(5000, 'a') + "b", names), "");
}
TEST(NearName, IsOfferedAsAQuestion) {
    EXPECT_EQ(suggestion("ushrink", kNames), "; did you mean 'uShrink'?");
    EXPECT_EQ(suggestion("volume", kNames), "");
}

}  // namespace
}  // namespace glibra::plan
