#include "view/edit/source_lines.h"

#include <gtest/gtest.h>

namespace glibra::test {
namespace {

using view::TextRange;
using Ranges = std::vector<TextRange>;

constexpr std::string_view kText = "float uKd, UKD;\nfloat uKdd;\n";

TEST(TextSearch, FindsEveryPlace) {
    EXPECT_EQ(view::findAll(kText, {"ukd", false, false}), (Ranges{{6, 9}, {11, 14}, {22, 25}}));
    EXPECT_EQ(view::findAll(kText, {"uKd", true, false}), (Ranges{{6, 9}, {22, 25}}));
    EXPECT_EQ(view::findAll(kText, {"ukd", false, true}), (Ranges{{6, 9}, {11, 14}}));
    EXPECT_EQ(view::findAll(kText, {"uKd", true, true}), (Ranges{{6, 9}}));
    EXPECT_TRUE(view::findAll(kText, {"none", false, false}).empty());
    EXPECT_TRUE(view::findAll(kText, {"", false, false}).empty());
    EXPECT_TRUE(view::findAll("", {"a", false, false}).empty());
}

TEST(TextSearch, PlacesDoNotOverlap) {
    EXPECT_EQ(view::findAll("aaaaa", {"aa", true, false}), (Ranges{{0, 2}, {2, 4}}));
    // A match that is not a whole word does not hide a later one that overlaps it.
    EXPECT_EQ(view::findAll("xa a", {"a", true, true}), (Ranges{{3, 4}}));
    EXPECT_EQ(view::findAll("x;;;", {";;", true, true}), (Ranges{{1, 3}}))
        << "words begin and end at letters";
}

TEST(TextSearch, GoesRound) {
    const Ranges found{{2, 3}, {5, 6}, {9, 10}};
    EXPECT_EQ(view::nextFound(found, 0), 0U);
    EXPECT_EQ(view::nextFound(found, 5), 1U);
    EXPECT_EQ(view::nextFound(found, 6), 2U);
    EXPECT_EQ(view::nextFound(found, 10), 0U);
    EXPECT_EQ(view::previousFound(found, 9), 1U);
    EXPECT_EQ(view::previousFound(found, 2), 2U);
    EXPECT_EQ(view::previousFound(found, 100), 2U);
}

TEST(TextSearch, ReplacesThePlacesOnly) {
    const Ranges found = view::findAll(kText, {"uKd", true, true});
    EXPECT_EQ(view::replaced(kText, found, "uAmbient"), "float uAmbient, UKD;\nfloat uKdd;\n");
    EXPECT_EQ(view::replaced(kText, view::findAll(kText, {"float ", true, false}), ""), "uKd, UKD;\nuKdd;\n");
    EXPECT_EQ(view::replaced(kText, {}, "x"), kText);
}

TEST(TextSearch, FindsTheEndOfAWord) {
    const std::string_view text = "  vec3 uA_1 += .5;\n  next";
    EXPECT_EQ(view::endOfWord(text, 0), 6U) << "after blanks";
    EXPECT_EQ(view::endOfWord(text, 3), 6U);
    EXPECT_EQ(view::endOfWord(text, 6), 11U);
    EXPECT_EQ(view::endOfWord(text, 12), 14U) << "signs";
    EXPECT_EQ(view::endOfWord(text, 18), 19U) << "a line end";
    EXPECT_EQ(view::endOfWord(text, 19), text.size());
    EXPECT_EQ(view::endOfWord(text, text.size()), text.size());
}

}  // namespace
}  // namespace glibra::test
