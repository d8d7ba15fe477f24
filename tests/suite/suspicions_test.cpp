#include "suite/suspicions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glibra::suite {
namespace {

const ShotReference kDrawn{0, 1};
const ShotReference kPrepared{0, 2};

ShotResult resultOf(const char* shot, Verdict verdict) {
    ShotResult result;
    result.shot = shot;
    result.verdict = verdict;
    return result;
}

/// "drawn passed, prepared crashed": what is told once both have been drawn by themselves.
std::string told(Verdict drawn, Verdict prepared, bool isDrawnFirst) {
    Suspicions suspicions;
    suspicions.add(kDrawn, kPrepared, resultOf("drawn", Verdict::crashed));
    std::vector<ShotResult> all;
    for (const bool isDrawn : {isDrawnFirst, !isDrawnFirst})
        for (ShotResult& each : isDrawn ? suspicions.settle(kDrawn, resultOf("drawn", drawn))
                                        : suspicions.settle(kPrepared, resultOf("prepared", prepared)))
            all.push_back(std::move(each));
    std::sort(all.begin(), all.end(),
              [](const ShotResult& a, const ShotResult& b) { return a.shot < b.shot; });
    std::string text;
    for (const ShotResult& each : all) text += each.shot + (isFailure(each.verdict) ? " bad " : " good ");
    return text;
}

TEST(Suspicions, FallOnTheShotThatEndsItsWorkerAgain) {
    for (const bool isDrawnFirst : {true, false}) {
        EXPECT_EQ(told(Verdict::passed, Verdict::crashed, isDrawnFirst), "drawn good prepared bad ");
        EXPECT_EQ(told(Verdict::passed, Verdict::timedOut, isDrawnFirst), "drawn good prepared bad ");
        EXPECT_EQ(told(Verdict::crashed, Verdict::passed, isDrawnFirst), "drawn bad prepared good ");
        EXPECT_EQ(told(Verdict::crashed, Verdict::crashed, isDrawnFirst), "drawn bad prepared bad ");
    }
}

TEST(Suspicions, StayOnTheShotThatWasDrawnIfNeitherDoesItAgain) {
    for (const bool isDrawnFirst : {true, false})
        EXPECT_EQ(told(Verdict::passed, Verdict::passed, isDrawnFirst), "drawn bad prepared good ");
}

TEST(Suspicions, AreNoneOfTheOthers) {
    Suspicions suspicions;
    suspicions.add(kDrawn, kPrepared, resultOf("drawn", Verdict::crashed));
    EXPECT_TRUE(suspicions.isUnder(kDrawn));
    EXPECT_TRUE(suspicions.isUnder(kPrepared));
    EXPECT_FALSE(suspicions.isUnder({0, 3}));
    EXPECT_EQ(suspicions.settle({0, 3}, resultOf("other", Verdict::passed)).size(), 1U);
}

}  // namespace
}  // namespace glibra::suite
