// The names of files that are named after students.
#include "classroom/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace glibra::classroom {
namespace {

using Names = std::vector<std::string>;

TEST(FileNames, StayWhereTheyAreNamesEverywhere) {
    const Names names{"Ana Lee", "=cmd Zhuo", "J. P. O'Hara, Jr", "\xC3\x9Cnal", "\xE6\x9D\x8E (12)"};
    EXPECT_EQ(fileNames(names), names);
}

TEST(FileNames, HaveNothingThatWindowsRefuses) {
    EXPECT_EQ(fileNames({"=cmd|calc Zhuo", "a/b\\c:d*e?f\"g<h>i", "con", "Aux.b", "LPT1", "conin$", ".hidden",
                         "", "dot. .", "line\nbreak\x7F", "\xFF"}),
              (Names{"=cmd_calc Zhuo", "a_b_c_d_e_f_g_h_i", "0003 con", "0004 Aux.b", "0005 LPT1",
                     "0006 conin$", "0007 .hidden", "0008 ", "dot", "line_break_", "_"}));
}

TEST(FileNames, AreApartOnADiskThatIgnoresCase) {
    const Names made = fileNames({"Ana", "ana", "ANA", "a:b", "a|b", "a_b", "0002 ana"});
    std::set<std::string> folded;
    for (std::string each : made) {
        std::ranges::transform(each, each.begin(), [](unsigned char one) { return std::tolower(one); });
        EXPECT_TRUE(folded.insert(each).second) << each;
    }
    EXPECT_EQ(made.front(), "Ana");
}

TEST(FileNames, AreCutBetweenCharacters) {
    std::string name;
    for (int i = 0; i < 150; ++i) name += "\xC3\xBC";
    const std::string made = fileNames({"x" + name}).front();
    EXPECT_EQ(made.size(), 199U);
    EXPECT_TRUE(made.ends_with("\xC3\xBC"));
}

}  // namespace
}  // namespace glibra::classroom
