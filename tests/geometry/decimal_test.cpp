// Decimal numbers that are read several digits at a time, compared with std::from_chars.

#include "geometry/obj/obj_plain.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>

namespace glibra::geometry {
namespace {

struct Read {
    bool isRead = false;
    float value = 0;
    std::size_t length = 0;
};

Read read(const std::string& text) {
    const std::string padded = text + std::string(kDecimalReach, '\n');
    Read result;
    const char* const rest = readDecimal(padded.data(), result.value);
    result.isRead = rest != nullptr;
    if (result.isRead) result.length = static_cast<std::size_t>(rest - padded.data());
    return result;
}

TEST(Digits, AreCountedUpToTheFirstOtherByte) {
    for (std::size_t count = 0; count <= 8; ++count)
        for (const char other : {' ', '/', ':', '.', '\n', '\0', '\x7f', '\x80', '\xff', '\xb5'}) {
            const std::string all = "98765432";
            const std::string text = all.substr(0, count) + other + "1111111";
            const Digits digits = digitsAt(text.data());
            EXPECT_EQ(digits.count, count) << static_cast<int>(other);
            EXPECT_EQ(digits.value, count == 0 ? 0 : std::stoull(all.substr(0, count)));
        }
}

TEST(Decimal, IsTheNearestFloatAsTheStandardLibraryReadsIt) {
    std::mt19937_64 random(7);
    const auto digits = [&](std::uint64_t most) {
        std::string text;
        for (std::uint64_t i = random() % (most + 1); i > 0; --i)
            text += static_cast<char>('0' + random() % 10);
        return text;
    };
    int compared = 0;
    for (int i = 0; i < 300'000; ++i) {
        const std::string number = digits(7) + "." + digits(9);
        const std::string text = (random() % 2 == 0 ? "-" : "") + number;
        const Read found = read(text);
        if (!found.isRead) continue;
        ++compared;
        float expected = 0;
        const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), expected);
        ASSERT_TRUE(failure == std::errc{}) << text;
        ASSERT_EQ(std::bit_cast<std::uint32_t>(found.value), std::bit_cast<std::uint32_t>(expected)) << text;
        ASSERT_EQ(found.length, static_cast<std::size_t>(rest - text.data())) << text;
    }
    EXPECT_GT(compared, 250'000);
}

TEST(Decimal, HalfWayBetweenTwoFloatsIsLeftToTheStandardLibrary) {
    // 2^24 + 1 with decimals: the double is exact and lies half way between two floats.
    EXPECT_FALSE(read("2097152.125").isRead);
    EXPECT_FALSE(read("4194304.250").isRead);
    EXPECT_TRUE(read("4194304.251").isRead);
    EXPECT_EQ(read("4194304.251").value, 4194304.5F);
}

TEST(Decimal, OfAnotherFormIsNotRead) {
    for (const char* text :
         {"", "-", ".", "-.", "1e5", "1.5E3", "1.2.3", "x", "12345678", "1.2345678901234567"})
        EXPECT_FALSE(read(text).isRead) << text;
    for (const char* text : {"0", "-0", "+1", "5.", ".5", "-.25", "1234567.8"})
        EXPECT_TRUE(read(text).isRead) << text;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(read("-0").value), 0x80000000U);
}

}  // namespace
}  // namespace glibra::geometry
