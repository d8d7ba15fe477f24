#include "base/workers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>

#include "worker_log.h"

namespace glibra::base {
namespace {

using namespace std::chrono_literals;

TEST(Workers, EveryPieceIsDoneExactlyOnce) {
    for (const int workers : {1, 2, 5}) {
        const Log log = runAll(17, {.workers = workers},
                               [](std::size_t index, const Step&) { return std::to_string(index * index); });
        ASSERT_EQ(log.outcomes.size(), 17U);
        for (const auto& [index, outcome] : log.outcomes) {
            EXPECT_EQ(outcome.end, Outcome::End::finished);
            EXPECT_EQ(outcome.answer, std::to_string(index * index));
        }
    }
}

TEST(Workers, AWorkerKeepsItsStateFromPieceToPiece) {
    int seen = 0;
    const Log log = runAll(4, {.workers = 1},
                           [seen](std::size_t, const Step&) mutable { return std::to_string(++seen); });
    EXPECT_EQ(log.outcomes.at(3).answer, "4");
    EXPECT_EQ(seen, 0) << "the calling process did the work itself";
}

TEST(Workers, ACrashCostsOnlyItsOwnPiece) {
    const Log log = runAll(6, {.workers = 2}, [](std::size_t index, const Step&) -> std::string {
        if (index == 2) std::abort();
        if (index == 4) std::_Exit(7);
        return "good";
    });
    ASSERT_EQ(log.outcomes.size(), 6U);
    for (const auto& [index, outcome] : log.outcomes) {
        const bool bad = index == 2 || index == 4;
        EXPECT_EQ(outcome.end, bad ? Outcome::End::crashed : Outcome::End::finished) << index;
    }
    EXPECT_EQ(log.outcomes.at(2).signal, SIGABRT);
    EXPECT_EQ(log.outcomes.at(4).signal, 0);
}

TEST(Workers, APieceThatHangsIsEndedAndTheOthersGoOn) {
    const Log log =
        runAll(3, {.workers = 1, .timeout = 0.2}, [](std::size_t index, const Step&) -> std::string {
            if (index == 1) std::this_thread::sleep_for(60s);
            return "good";
        });
    EXPECT_EQ(log.outcomes.at(0).end, Outcome::End::finished);
    EXPECT_EQ(log.outcomes.at(1).end, Outcome::End::timedOut);
    EXPECT_EQ(log.outcomes.at(2).end, Outcome::End::finished);
}

TEST(Workers, LongMessagesArriveWhole) {
    const Log log = runAll(3, {.workers = 2}, [](std::size_t index, const Step& step) {
        for (int i = 0; i < 100; ++i) step(std::string(static_cast<std::size_t>(i) * 997, 's'));
        return std::string(5'000'000 + index, static_cast<char>('a' + index));
    });
    for (const auto& [index, outcome] : log.outcomes)
        EXPECT_EQ(outcome.answer, std::string(5'000'000 + index, static_cast<char>('a' + index)));
    EXPECT_EQ(log.steps.at(2), 100);
}

TEST(Workers, EveryStepBeginsTheTimeLimitAnew) {
    const Log log =
        runAll(1, {.workers = 1, .timeout = 1.0}, [](std::size_t, const Step& step) -> std::string {
            for (int i = 0; i < 6; ++i) {
                std::this_thread::sleep_for(300ms);
                step("frame");
            }
            return "done";
        });
    EXPECT_EQ(log.outcomes.at(0).end, Outcome::End::finished);
    EXPECT_EQ(log.steps.at(0), 6);
}

TEST(Workers, EveryPieceMayHaveATimeLimitOfItsOwn) {
    const Log log = runAll(
        3, {.workers = 3, .timeout = 60, .timeoutOf = [](std::size_t index) { return index == 1 ? .1 : 0.; }},
        [](std::size_t, const Step&) {
            std::this_thread::sleep_for(400ms);
            return std::string("done");
        });
    EXPECT_EQ(log.outcomes.at(0).end, Outcome::End::finished);
    EXPECT_EQ(log.outcomes.at(1).end, Outcome::End::timedOut);
    EXPECT_EQ(log.outcomes.at(2).end, Outcome::End::finished);
}

TEST(Workers, AfterAStopNothingIsBegunAndWhatIsInWorkIsEnded) {
    int done = 0;
    Log log;
    runInWorkers(
        10, {.workers = 1, .stop = [&] { return done == 3; }},
        [](std::size_t index, const Step&) {
            if (index == 3) std::this_thread::sleep_for(60s);
            return std::string();
        },
        [&](std::size_t index, const Outcome& outcome) {
            log.outcomes[index] = outcome;
            ++done;
        },
        [](std::size_t, const std::string&) {});
    EXPECT_EQ(log.outcomes.size(), 3U);
}

TEST(Workers, AStopEndsAPieceThatHangs) {
    bool began = false;
    Log log;
    runInWorkers(
        2, {.workers = 1, .stop = [&] { return began; }},
        [](std::size_t, const Step& step) {
            step("began");
            std::this_thread::sleep_for(60s);
            return std::string();
        },
        [&](std::size_t index, const Outcome& outcome) { log.outcomes[index] = outcome; },
        [&](std::size_t, const std::string&) { began = true; });
    ASSERT_EQ(log.outcomes.size(), 1U);
    EXPECT_EQ(log.outcomes.at(0).end, Outcome::End::stopped);
    EXPECT_GT(log.outcomes.at(0).process, 0);
}

TEST(Workers, ACrashNearTheLimitOfMemoryIsReportedAsSuch) {
    constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
    const Log log = runAll(2, {.workers = 1, .memory = kLimit}, [](std::size_t index, const Step&) {
        std::string all(index == 0 ? kLimit * 3 / 4 : 1, 'x');
        if (all.back() == 'x') std::abort();
        return all;
    });
    EXPECT_TRUE(log.outcomes.at(0).nearMemoryLimit);
    EXPECT_FALSE(log.outcomes.at(1).nearMemoryLimit);
}

TEST(Workers, KnowThatTheyAreWorkers) {
    EXPECT_FALSE(isWorker());
    const Log log = runAll(1, {.workers = 1},
                           [](std::size_t, const Step&) { return std::string(isWorker() ? "yes" : "no"); });
    EXPECT_EQ(log.outcomes.at(0).answer, "yes");
    EXPECT_FALSE(isWorker());
}

TEST(Workers, KnowHowMuchTimeTheirStepHas) {
    EXPECT_FALSE(stepTime());
    const Log log = runAll(1, {.workers = 1, .timeout = 60}, [](std::size_t, const Step& step) {
        std::this_thread::sleep_for(50ms);
        const auto before = stepTime();
        step("again");
        const auto after = stepTime();
        const bool good =
            before && after && before->limit == 60 && before->left < 59.96 && after->left > before->left;
        return std::string(good ? "yes" : "no");
    });
    EXPECT_EQ(log.outcomes.at(0).answer, "yes");
    const Log unlimited = runAll(1, {.workers = 1}, [](std::size_t, const Step&) {
        return std::string(stepTime() ? "limit" : "none");
    });
    EXPECT_EQ(unlimited.outcomes.at(0).answer, "none");
}

TEST(Workers, LongAnswersArriveWhole) {
    const std::string big(5'000'000, 'x');
    const Log log = runAll(3, {.workers = 3}, [&](std::size_t, const Step&) { return std::string(big); });
    for (const auto& [index, outcome] : log.outcomes) EXPECT_EQ(outcome.answer, big) << index;
}

}  // namespace
}  // namespace glibra::base
