#include "base/text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace glibra::base {
namespace {

TEST(Text, GroupsHaveCommasBetweenThousands) {
    EXPECT_EQ(groupedText(0), "0");
    EXPECT_EQ(groupedText(999), "999");
    EXPECT_EQ(groupedText(1000), "1,000");
    EXPECT_EQ(groupedText(81017999), "81,017,999");
    EXPECT_EQ(groupedText(-100000), "-100,000");
    EXPECT_EQ(groupedText(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
}

TEST(Text, CountedNounsAgreeWithTheirNumber) {
    EXPECT_EQ(counted(1, "number"), "1 number");
    EXPECT_EQ(counted(0, "number"), "0 numbers");
    EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
    EXPECT_EQ(counted(4096, "vertex", "vertices"), "4096 vertices");
    EXPECT_EQ(countedInGroups(4096, "byte"), "4,096 bytes");
    EXPECT_EQ(countedInGroups(1, "byte"), "1 byte");
}

TEST(ReadableBytes, AreRoundedUpSoThatASizeBeyondALimitLooksLarger) {
    EXPECT_EQ(readableBytes(17), "17 bytes");
    EXPECT_EQ(readableBytes(4096), "4096 bytes");
    EXPECT_EQ(readableBytes(3 << 20), "3 MiB");
    EXPECT_EQ(readableBytes((3 << 20) + 1), "3.1 MiB");
    EXPECT_EQ(readableBytes(std::uint64_t{1} << 30), "1 GiB");
    EXPECT_EQ(readableBytes((std::uint64_t{1} << 30) + 1), "1.1 GiB");
    EXPECT_EQ(readableBytes(~std::uint64_t{0}), "16 EiB");
}

}  // namespace
}  // namespace glibra::base
