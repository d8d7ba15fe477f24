// Tests of --only and --shard: which shots run on which machine.

#include "suite/file/selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace glibra::suite::test {
namespace {

Shot taggedShot(std::string name, std::vector<std::string> tags = {}) {
    Shot made;
    made.name = std::move(name);
    made.tags = std::move(tags);
    return made;
}

Suite numbered(int count) {
    Suite suite;
    suite.name = "many";
    for (int i = 0; i < count; ++i) suite.shots.push_back(taggedShot("shot" + std::to_string(i)));
    return suite;
}

std::string names(const Suite& suite, const std::vector<std::string>& only, Shard shard = {}) {
    std::string all;
    for (const std::size_t each : select(suite, only, shard)) all += suite.shots[each].name + " ";
    return all;
}

TEST(Shards, AreReadAsIOfN) {
    const auto shard = parseShard("2/8");
    ASSERT_TRUE(shard);
    EXPECT_EQ(shard->index, 2);
    EXPECT_EQ(shard->count, 8);
    for (const char* wrong : {"", "2", "/", "0/8", "9/8", "-1/8", "2/8x", "2 / 8", "2/", "1/1000001",
                              "99999999999/99999999999", "+1/2", "1/2/3"}) {
        const auto refused = parseShard(wrong);
        EXPECT_FALSE(refused) << wrong;
        EXPECT_EQ(refused.diagnostics.at(0).id, "suite-E16");
    }
}

TEST(Shards, CoverEveryShotOnce) {
    const Suite suite = numbered(1000);
    std::set<std::size_t> seen;
    for (int i = 1; i <= 7; ++i)
        for (const std::size_t each : select(suite, {}, {i, 7})) EXPECT_TRUE(seen.insert(each).second);
    EXPECT_EQ(seen.size(), suite.shots.size());
}

TEST(Shards, AreAboutOfOneSize) {
    // 10,000 shots on 16 machines: 625 each, with a standard deviation of 24 for a random choice.
    const Suite suite = numbered(10'000);
    for (int i = 1; i <= 16; ++i) {
        const auto count = static_cast<double>(select(suite, {}, {i, 16}).size());
        EXPECT_NEAR(count, 625, 5 * 24.2);
    }
}

TEST(Shards, StayWhereTheyAreWhenShotsAreAdded) {
    const Suite suite = numbered(100);
    Suite more = suite;
    more.shots.insert(more.shots.begin() + 50, taggedShot("new"));
    more.shots.insert(more.shots.begin(), taggedShot("newer"));
    for (int i = 1; i <= 4; ++i) {
        std::set<std::string> before;
        std::set<std::string> after;
        for (const std::size_t each : select(suite, {}, {i, 4})) before.insert(suite.shots[each].name);
        for (const std::size_t each : select(more, {}, {i, 4})) after.insert(more.shots[each].name);
        EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    }
}

TEST(Shards, AreGivenByTheDocumentedHash) {
    // The hash of ("start", "teapot") from an independent program: FNV-1a 64, then fmix64 of MurmurHash3
    // (Python).
    EXPECT_EQ(shardOf("start", "teapot", 1000), 609);
    EXPECT_EQ(shardOf("", "", 1000), 267);
    EXPECT_NE(shardOf("ab", "c", 1'000'000), shardOf("a", "bc", 1'000'000));
}

TEST(Shards, KeepPicturesThatAreComparedTogether) {
    Suite suite = numbered(64);
    for (std::size_t i = 1; i < 64; i += 2) suite.shots[i].match = suite.shots[i - 1].name;
    suite.shots[2].differ = "shot0";   // a chain: shot3, shot2, shot0
    suite.shots[63].differ = "shot5";  // one with two
    for (int i = 1; i <= 8; ++i) {
        std::set<std::string> part;
        for (const std::size_t each : select(suite, {}, {i, 8})) part.insert(suite.shots[each].name);
        for (const Shot& each : suite.shots)
            for (const std::string& other : {each.match, each.differ})
                if (!other.empty()) {
                    EXPECT_EQ(part.contains(each.name), part.contains(other));
                }
    }
}

TEST(Shards, OfAGroupStayWhenAShotThatNamesOneIsAdded) {
    Suite suite;
    suite.name = "s";
    suite.shots = {taggedShot("m"), taggedShot("n")};
    suite.shots[1].match = "m";
    EXPECT_EQ(shardNames(suite).at(1), "m");
    suite.shots.push_back(taggedShot("a"));  // earlier in the alphabet, and names n
    suite.shots[2].differ = "n";
    EXPECT_EQ(shardNames(suite), (std::vector<std::string_view>{"m", "m", "m"}));
}

TEST(Selection, TakesNamesSweepsAndTags) {
    Suite suite;
    suite.shots = {taggedShot("teapot"), taggedShot("oval@uTol=0"), taggedShot("oval@uTol=0.1", {"slow"}),
                   taggedShot("start/teapot", {"slow"}), taggedShot("ovals")};
    EXPECT_EQ(names(suite, {}), "teapot oval@uTol=0 oval@uTol=0.1 start/teapot ovals ");
    EXPECT_EQ(names(suite, {"teapot"}), "teapot ");
    EXPECT_EQ(names(suite, {"*teapot"}), "teapot start/teapot ");
    EXPECT_EQ(names(suite, {"oval"}), "oval@uTol=0 oval@uTol=0.1 ");
    EXPECT_EQ(names(suite, {"oval@uTol=0.1"}), "oval@uTol=0.1 ");
    EXPECT_EQ(names(suite, {"tag:slow"}), "oval@uTol=0.1 start/teapot ");
    EXPECT_EQ(names(suite, {"tag:s*", "ovals"}), "oval@uTol=0.1 start/teapot ovals ");
    EXPECT_EQ(names(suite, {"nothing"}), "");
}

TEST(Selection, TakesWithAShotWhatItIsComparedWith) {
    Suite suite;
    suite.shots = {taggedShot("a"), taggedShot("b"), taggedShot("c"), taggedShot("d")};
    suite.shots[2].match = "b";
    suite.shots[1].differ = "a";
    EXPECT_EQ(names(suite, {"c"}), "a b c ");
}

TEST(Selection, NamesPatternsThatMeanNothing) {
    std::vector<Suite> suites(2);
    suites[0].shots = {taggedShot("teapot"), taggedShot("oval@uTol=0", {"slow"})};
    suites[1].shots = {taggedShot("cow")};
    EXPECT_TRUE(unmatchedPatterns(suites, std::vector<std::string>{"cow", "tea*", "tag:slow"}).empty());
    const auto problems =
        unmatchedPatterns(suites, std::vector<std::string>{"teapto", "ovla", "tag:slwo", "x*", "cow"});
    ASSERT_EQ(problems.size(), 4U);
    EXPECT_EQ(problems[0].text, "no shot matches --only 'teapto'; did you mean 'teapot'?");
    EXPECT_EQ(problems[1].text, "no shot matches --only 'ovla'; did you mean 'oval'?");
    EXPECT_EQ(problems[2].text, "no shot matches --only 'tag:slwo'; did you mean 'tag:slow'?");
    EXPECT_EQ(problems[3].text, "no shot matches --only 'x*'");
    EXPECT_EQ(problems[3].id, "suite-E15");
}

/// A picture without a golden and a pair of its own is compared only if those that name it run, too.
TEST(Selection, APictureThatOnlyOthersCompareBringsThemAlong) {
    Suite suite;
    suite.shots = {taggedShot("a"), taggedShot("b"), taggedShot("c"), taggedShot("d")};
    suite.shots[0].golden = false;
    suite.shots[1].match = "a";
    suite.shots[3].differ = "b";
    EXPECT_EQ(names(suite, {"a"}), "a b ");
    suite.shots[0].golden = true;
    EXPECT_EQ(names(suite, {"a"}), "a ");
    suite.shots[0].golden = false;
    EXPECT_EQ(select(suite, std::vector<std::string>{"a"}, {}, false), std::vector<std::size_t>{0})
        << "not with --update";
}

}  // namespace
}  // namespace glibra::suite::test
