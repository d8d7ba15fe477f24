// All verdicts on one picture: with and without a golden, a list of accepted pixels, checks, pairs and
// options, compared with the rules of docs/suites.md as they are written there.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "folder.h"
#include "pictures.h"
#include "suite/run/verdict.h"

namespace glibra::suite {
namespace {

enum class GoldenIs { missing, same, other };
enum class ListHas { nothing, goldenAndPixels, otherGolden, otherVariant };
enum class Checks { none, hold, fail };
enum class Pair { none, matches, matchFails, isPartner };

struct Case {
    GoldenIs golden{};
    ListHas list{};
    Checks checks{};
    Pair pair{};
    bool wantsGolden = true, update = false, otherShotHas = false;

    [[nodiscard]] std::string text() const {
        return fmt::format("golden {}, list {}, checks {}, pair {}, wants golden {}, update {}, other {}",
                           static_cast<int>(golden), static_cast<int>(list), static_cast<int>(checks),
                           static_cast<int>(pair), wantsGolden, update, otherShotHas);
    }
};

/// The rules in the order of the page.
Verdict expected(const Case& each) {
    if (each.checks == Checks::fail) return Verdict::failed;
    const bool hasPair = each.pair != Pair::none;
    if (!each.wantsGolden && each.checks == Checks::none && !hasPair) return Verdict::failed;  // suite-E21
    const bool pairHolds = each.pair != Pair::matchFails;
    if (!each.wantsGolden) return pairHolds ? Verdict::passed : Verdict::failed;
    if (each.golden == GoldenIs::missing) {
        if (each.update) return pairHolds ? Verdict::updated : Verdict::failed;
        // Checks suffice where the suite has no goldens at all.
        const bool suiteHasSome = each.list != ListHas::nothing || each.otherShotHas;
        if (each.checks == Checks::none || suiteHasSome) return Verdict::missing;
        return pairHolds ? Verdict::passed : Verdict::failed;
    }
    // Whatever the list says, the golden decides.
    if (each.golden != GoldenIs::same) return each.update && pairHolds ? Verdict::updated : Verdict::failed;
    return pairHolds ? Verdict::passed : Verdict::failed;
}

class VerdictMatrix : public testing::Test {
  protected:
    static ShotResult decide(const Case& each) {
        const Folder folder;
        Suite suite;
        suite.name = "s";
        suite.file = "s.toml";
        suite.goldens = folder / "goldens";
        const image::Image got = gradient(), other = gradient(40);
        Shot shot = shotNamed("a");
        shot.golden = each.wantsGolden;
        if (each.pair == Pair::matches || each.pair == Pair::matchFails) shot.match = "b";
        Shot partner = shotNamed("b");
        if (each.pair == Pair::isPartner) partner.match = "a";
        suite.shots = {shot, partner};

        const GoldenStore store = *GoldenStore::open(suite);
        std::filesystem::create_directories(suite.goldens);
        Hash identity = hashOf(got);
        if (each.golden != GoldenIs::missing) {
            const Result<Golden> made = store.replace(shot, "", each.golden == GoldenIs::same ? got : other);
            identity = made->identity;
        }
        if (each.otherShotHas) {
            EXPECT_TRUE(store.replace(partner, "", other));
        }
        std::vector<AcceptedHash> lines;
        if (each.list == ListHas::goldenAndPixels) lines.push_back({"a", "", identity, hashOf(got), "key"});
        if (each.list == ListHas::otherGolden) lines.push_back({"a", "", hashOf(other), hashOf(got), "key"});
        if (each.list == ListHas::otherVariant)
            lines.push_back({"a", "nvidia", identity, hashOf(got), "key"});
        EXPECT_TRUE(acceptHashes(store.hashFile(), lines).empty());

        const GoldenStore opened = *GoldenStore::open(suite);
        const ShotJudge judge(suite, opened, "llvmpipe", "key",
                              {.update = each.update, .results = folder / "results"});
        Attempt attempt = attemptAt(suite.shots.front(), got);
        attempt.own.hasChecks = each.checks != Checks::none;
        if (each.checks == Checks::fail) attempt.own.failedChecks.push_back(diagnose("check-E01", "5 == 7"));
        if (!shot.match.empty())
            attempt.match.emplace().picture = each.pair == Pair::matches ? got : gradient(80);
        if (std::optional<Judged> first = judge.first(attempt)) return first->result;
        return judge.second(attempt, attempt).result;
    }
};

TEST_F(VerdictMatrix, EveryCombinationIsJudgedByTheRules) {
    int count = 0;
    std::map<Verdict, int> seen;
    for (const GoldenIs golden : {GoldenIs::missing, GoldenIs::same, GoldenIs::other})
        for (const ListHas list :
             {ListHas::nothing, ListHas::goldenAndPixels, ListHas::otherGolden, ListHas::otherVariant})
            for (const Checks checks : {Checks::none, Checks::hold, Checks::fail})
                for (const Pair pair : {Pair::none, Pair::matches, Pair::matchFails, Pair::isPartner})
                    for (int bits = 0; bits < 8; ++bits) {
                        const Case each{golden,          list,           checks, pair, (bits & 1) != 0,
                                        (bits & 2) != 0, (bits & 4) != 0};
                        // Where there is a golden, those of others do not matter.
                        if (each.otherShotHas && golden != GoldenIs::missing) continue;
                        const ShotResult result = decide(each);
                        EXPECT_EQ(name(result.verdict), std::string(name(expected(each))))
                            << each.text() << "\n"
                            << result.reason;
                        if (isFailure(result.verdict)) {
                            EXPECT_FALSE(result.reason.empty()) << each.text();
                        }
                        ++seen[result.verdict];
                        ++count;
                    }
    EXPECT_EQ(count, 4 * 3 * 4 * (8 + 4 + 4));
    EXPECT_GT(seen[Verdict::passed], 50);
    EXPECT_GT(seen[Verdict::missing], 20);
    EXPECT_GT(seen[Verdict::updated], 20);
}

/// What is green was compared: with a golden, with a pair, or by a check that holds.
TEST_F(VerdictMatrix, NothingPassesThatWasComparedWithNothing) {
    Case each;
    each.wantsGolden = false;
    const ShotResult result = decide(each);
    EXPECT_EQ(result.verdict, Verdict::failed);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics.back().id, "suite-E21");
}

TEST_F(VerdictMatrix, AMissingGoldenThatTheListNamesIsNamed) {
    Case each;
    each.checks = Checks::hold;
    each.list = ListHas::otherVariant;
    const ShotResult result = decide(each);
    EXPECT_EQ(result.verdict, Verdict::missing);
    EXPECT_NE(result.reason.find("a.nvidia.png"), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("s.hashes"), std::string::npos) << result.reason;
}

/// A new scene that checks itself is no reason to forget its golden.
TEST_F(VerdictMatrix, AMissingGoldenIsNamedWhereOtherShotsHaveTheirs) {
    Case each;
    each.checks = Checks::hold;
    EXPECT_EQ(decide(each).verdict, Verdict::passed);
    each.otherShotHas = true;
    const ShotResult result = decide(each);
    EXPECT_EQ(result.verdict, Verdict::missing);
    EXPECT_NE(result.reason.find("a.png"), std::string::npos) << result.reason;
    EXPECT_NE(result.reason.find("golden = false"), std::string::npos) << result.reason;
    EXPECT_FALSE(result.accept.empty());
    each.wantsGolden = false;
    each.pair = Pair::isPartner;
    EXPECT_EQ(decide(each).verdict, Verdict::passed);
}

TEST(LostGolden, WhileTheListCannotBeReadEveryShotNeedsItsGolden) {
    const Folder folder;
    Suite suite;
    suite.name = "s";
    suite.file = "s.toml";
    suite.goldens = folder / "goldens";
    std::filesystem::create_directories(suite.goldens / "s.hashes");  // a folder is no list
    const Result<GoldenStore> store = GoldenStore::open(suite);
    EXPECT_FALSE(store.diagnostics.empty());
    EXPECT_FALSE(store->lostGolden(shotNamed("a")).empty());
}

}  // namespace
}  // namespace glibra::suite
