// Numbers (language, 1.5).

#include "glib/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "scene.h"

namespace glibra::glib::test {
namespace {

TEST(Number, FormsOfTheLanguage) {
    for (const char* text :
         {"5", "5.", ".2", "-.25", "1e-3", "+4", "0", "-0", "1.5E+2", "007", "0.000", "12e0"}) {
        const auto number = numberPrefix(text);
        ASSERT_TRUE(number) << text;
        EXPECT_EQ(number->value, std::strtod(text, nullptr)) << text;
        EXPECT_EQ(number->length, std::string(text).size()) << text;
        EXPECT_TRUE(number->finite) << text;
        EXPECT_TRUE(isCompleteNumber(text)) << text;
    }
}

TEST(Number, WordsAreNoNumbers) {
    for (const char* text : {"", "+", "-", ".", "+.", "-.e1", "e5", "z", "?", "inf", "nan", "-inf", "NaN",
                             "0x10", "-0X1f", ".e", "--1", "+-1"})
        EXPECT_FALSE(numberPrefix(text)) << text;
}

TEST(Number, LongestPrefixIsUsed) {
    const auto check = [](std::string_view text, double value, std::size_t length) {
        const auto number = numberPrefix(text);
        ASSERT_TRUE(number) << text;
        EXPECT_EQ(number->value, value) << text;
        EXPECT_EQ(number->length, length) << text;
        EXPECT_FALSE(isCompleteNumber(text)) << text;
    };
    check("0.1.", .1, 3);
    check("1.5f", 1.5, 3);
    check("0,01", 0, 1);
    check("1,2,3", 1, 1);
    check("1e", 1, 1);
    check("1e+", 1, 1);
    check("2.e", 2, 2);
    check("3.e2x", 300, 4);
    check("0x", 0, 1);
    check("1-2", 1, 1);
    check("2.bmp", 2, 2);
}

TEST(Number, MagnitudesBeyondFloatAreNotFinite) {
    for (const char* text : {"1e39", "-1e39", "1e400", "1e99999999999999999999", "3.4028236e38"})
        EXPECT_FALSE(numberPrefix(text)->finite) << text;
    EXPECT_FALSE(numberPrefix(std::string(400, '9'))->finite);
}

TEST(Number, EdgeOfFloatAgreesWithTheConversion) {
    // The conversion to float rounds to nearest even, so the last double that stays finite lies below the
    // middle.
    for (const char* text : {"3.4028234e38", "3.40282350e38", "340282356779733661637539395458142568447.9",
                             "340282356779733661637539395458142568448"}) {
        const double exact = std::strtod(text, nullptr);
        EXPECT_EQ(numberPrefix(text)->finite, std::isfinite(static_cast<float>(exact))) << text;
    }
}

TEST(Number, TinyNumbersAreZero) {
    EXPECT_EQ(numberPrefix("1e-400")->value, 0);
    EXPECT_TRUE(numberPrefix("1e-400")->finite);
    EXPECT_TRUE(numberPrefix("0." + std::string(500, '0') + "1")->finite);
    EXPECT_TRUE(numberPrefix("1e-99999999999999999999")->finite);
    EXPECT_TRUE(numberPrefix("0e99999999999999999999")->finite);
    EXPECT_EQ(numberPrefix("0e99999999999999999999")->value, 0);
    EXPECT_TRUE(std::signbit(numberPrefix("-1e-400")->value));
}

TEST(Number, AgreesWithStrtodOnHashedDecimals) {
    std::uint32_t state = 1;
    const auto next = [&state](std::uint32_t bound) {
        std::uint32_t x = state++ * 0x9e3779b9U;
        x ^= x >> 16U;
        x *= 0x7feb352dU;
        x ^= x >> 15U;
        x *= 0x846ca68bU;
        x ^= x >> 16U;
        return x % bound;
    };
    for (int i = 0; i < 2000; ++i) {
        std::string text = next(2) == 0 ? "-" : "";
        text += std::to_string(next(100000)) + "." + std::to_string(next(1000000));
        if (next(2) == 0) text += "e" + std::to_string(static_cast<int>(next(60)) - 30);
        const auto number = numberPrefix(text);
        ASSERT_TRUE(number) << text;
        EXPECT_EQ(number->value, std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(Number, TextReadsBack) {
    for (const double value : {0.1, 3., 1e30, -2.5, 1. / 3, 5e-324, std::numeric_limits<double>::max()})
        EXPECT_EQ(std::strtod(numberText(value).c_str(), nullptr), value);
    EXPECT_EQ(numberText(3), "3");
    EXPECT_EQ(numberText(.1), "0.1");
}

TEST(NumberToken, RestAfterAPrefixIsIgnoredWithAWarning) {
    EXPECT_EQ(numbersOf("Translate 0.1. 1.5f 0,01"), (std::vector<double>{.1, 1.5, 0}));
    EXPECT_EQ(idsOf("Translate 0.1. 1.5f 0,01"), (Ids{"glib-W04", "glib-W04", "glib-W04"}));
}

TEST(NumberToken, WordIsReadAsZero) {
    EXPECT_EQ(numbersOf("Translate 1 z ?"), (std::vector<double>{1, 0, 0}));
    EXPECT_EQ(idsOf("Translate 1 z ?"), (Ids{"glib-W05", "glib-W05"}));
}

TEST(NumberToken, FractionIsCutTowardZero) {
    EXPECT_EQ(numbersOf("Sphere 1 10.9 4."), (std::vector<double>{1, 10, 4}));
    EXPECT_EQ(idsOf("Sphere 1 10.9 4."), Ids{"glib-W27"});
    EXPECT_EQ(numbersOf("JitterCloud 2 2 2 -1.9"), (std::vector<double>{2, 2, 2, -1}));
}

TEST(NumberToken, InfiniteNumberIsRefused) {
    EXPECT_EQ(idsOf("Translate 1e39 0 0"), Ids{"glib-E31"});
    EXPECT_TRUE(read("Translate 1e39 0 0").commands.empty());
    EXPECT_EQ(idsOf("Program P uA 1e400"), Ids{"glib-E31"});
    EXPECT_TRUE(read("Program P uA 1e400").commands.empty());
}

}  // namespace
}  // namespace glibra::glib::test
