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

TEST(ReasonOf, AnExceptionIsInPlainWords) {
    EXPECT_EQ(reasonOf(std::bad_alloc()), "out of memory (--memory)");
    EXPECT_EQ(reasonOf(std::bad_array_new_length()), "out of memory (--memory)");
    EXPECT_EQ(reasonOf(std::length_error("vector::_M_default_append")), "out of memory (--memory)");
    EXPECT_EQ(reasonOf(std::runtime_error("no folder")), "no folder");
    EXPECT_EQ(
        reasonOf(std::runtime_error("[json.exception.type_error.302] type must be number, but is string")),
        "expected number, found string");
    EXPECT_EQ(reasonOf(std::runtime_error("[json.exception.out_of_range.403] key 'a' not found")),
              "key 'a' not found");
    EXPECT_EQ(reasonOf(std::runtime_error("[json.exception.x")), "");
}

TEST(PlaceOfByte, CountsLinesAndColumnsFromOne) {
    for (const auto& [byte, line, column] : {std::array{0, 1, 1}, {1, 1, 1}, {3, 1, 3}, {4, 2, 1}, {6, 2, 3}})
        EXPECT_EQ(placeOfByte("ab\ncd", static_cast<std::size_t>(byte), "f"), (Place{"f", line, column}));
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
