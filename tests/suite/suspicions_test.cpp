#include "suite/run/run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace glibra::suite {
namespace {

const std::vector<ShotReference> kShots{{0, 1}, {0, 2}, {0, 3}};  // the first was being drawn
const char* const kNames[] = {"drawn", "next", "last"};

ShotResult resultOf(const char* shot, Verdict verdict) {
    ShotResult result;
    result.shot = shot;
    result.verdict = verdict;
    return result;
}

Suspicions ofAll() {
    Suspicions suspicions;
    suspicions.add(kShots[0], {kShots[1], kShots[2]}, resultOf("drawn", Verdict::crashed));
    return suspicions;
}

/// "drawn good, next bad, last good": the results that are reported when all shots have been drawn by
/// themselves, in every order.
std::set<std::string> told(const std::array<Verdict, 3>& verdicts) {
    std::set<std::string> texts;
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        Suspicions suspicions = ofAll();
        std::map<std::string, std::string> all;
        for (const std::size_t i : order)
            for (const ShotResult& each : suspicions.settle(kShots[i], resultOf(kNames[i], verdicts[i])))
                all[each.shot] += isFailure(each.verdict) ? " bad" : " good";
        texts.insert(all["drawn"] + "," + all["next"] + "," + all["last"]);
    } while (std::next_permutation(order.begin(), order.end()));
    return texts;
}

using Texts = std::set<std::string>;

TEST(Suspicions, FallOnTheShotThatEndsItsWorkerAgain) {
    using enum Verdict;
    EXPECT_EQ(told({passed, crashed, passed}), Texts{" good, bad, good"});
    EXPECT_EQ(told({passed, passed, timedOut}), Texts{" good, good, bad"});
    EXPECT_EQ(told({passed, crashed, crashed}), Texts{" good, bad, bad"});
    EXPECT_EQ(told({crashed, passed, passed}), Texts{" bad, good, good"});
    EXPECT_EQ(told({crashed, passed, crashed}), Texts{" bad, good, bad"});
}

TEST(Suspicions, MakeAForgivenShotFlakyUnlessAnotherOneIsGuilty) {
    using enum Verdict;
    const auto drawn = [](Verdict own, Verdict next) {
        Suspicions suspicions;
        suspicions.add(kShots[0], {kShots[1]}, resultOf("drawn", crashed), true);
        EXPECT_TRUE(suspicions.settle(kShots[0], resultOf("drawn", own)).empty());
        const std::vector<ShotResult> told = suspicions.settle(kShots[1], resultOf("next", next));
        return told.size() == 2 ? told[1].verdict : skipped;
    };
    EXPECT_EQ(drawn(passed, passed), flaky);
    EXPECT_EQ(drawn(failed, passed), failed) << "its own drawing counts";
    EXPECT_EQ(drawn(passed, crashed), passed) << "the other one ended the worker";
}

TEST(Suspicions, StayOnTheShotThatWasDrawnIfNoneDoesItAgain) {
    using enum Verdict;
    EXPECT_EQ(told({passed, passed, passed}), Texts{" bad, good, good"});
}

TEST(Suspicions, AreNoneOfTheOthers) {
    Suspicions suspicions = ofAll();
    for (const ShotReference& each : kShots) EXPECT_TRUE(suspicions.isUnder(each));
    EXPECT_FALSE(suspicions.isUnder({0, 4}));
    EXPECT_EQ(suspicions.settle({0, 4}, resultOf("other", Verdict::passed)).size(), 1U);
}

}  // namespace
}  // namespace glibra::suite
