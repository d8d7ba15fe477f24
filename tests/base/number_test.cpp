#include "base/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glibra::base {
namespace {

TEST(WholeNumber, IsTheOneThatRoundingErrorsMissed) {
    for (int tenths = 1; tenths < 2000; ++tenths) {
        const WholeNumber whole = wholeNumber(tenths * .1 / .1);
        EXPECT_EQ(whole.value, tenths);
        EXPECT_FALSE(whole.isCut);
    }
    double sum = 0;
    for (int i = 0; i < 10000; ++i) sum += .1;
    EXPECT_EQ(wholeNumber(sum).value, 1000);
    EXPECT_EQ(wholeNumber(-(.29 * 100)).value, -29);
    EXPECT_EQ(wholeNumber(2147483647.0).value, 2147483647.0);
}

TEST(WholeNumber, CutsFractionsTowardZero) {
    const double fractions[][2] = {{2.5, 2}, {-2.5, -2}, {.999, 0}, {-.001, 0}, {5.9999, 5}, {1e9 + .5, 1e9}};
    for (const auto& [fraction, cut] : fractions) {
        EXPECT_EQ(wholeNumber(fraction).value, cut) << fraction;
        EXPECT_FALSE(std::signbit(wholeNumber(fraction).value) && cut == 0) << fraction;
        EXPECT_TRUE(wholeNumber(fraction).isCut) << fraction;
    }
}

TEST(FitsFloat, EndsHalfAUnitAboveTheLargestFloat) {
    const double largest = std::numeric_limits<float>::max();
    EXPECT_TRUE(fitsFloat(largest));
    EXPECT_TRUE(fitsFloat(std::nextafter(0x1.ffffffp127, 0)));
    EXPECT_FALSE(fitsFloat(0x1.ffffffp127));
    EXPECT_FALSE(fitsFloat(-1e300));
    EXPECT_TRUE(fitsFloat(1e-300));
}

}  // namespace
}  // namespace glibra::base
