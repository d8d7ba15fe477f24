// Each of the shots that a worker has in hand has its own time.

#include "suite/run/run.h"

#include <gtest/gtest.h>

#include <chrono>

namespace glibra::suite {
namespace {

using Kind = Phase::Kind;
constexpr ShotReference kFirst{0, 0}, kSecond{0, 1}, kUnlimited{0, 2};

class Clocks : public testing::Test {
  protected:
    [[nodiscard]] static ShotClocks::Clock::time_point at(double seconds) {
        return ShotClocks::Clock::time_point(
            std::chrono::duration_cast<ShotClocks::Clock::duration>(std::chrono::duration<double>(seconds)));
    }
    void phase(Kind kind, const ShotReference& shot, double seconds) {
        clocks.hear(Phase{kind, shot}, at(seconds));
    }

    const std::function<double(const ShotReference&)> limitOf = [](const ShotReference& shot) {
        return shot == kFirst ? 5. : shot == kSecond ? 10. : 0.;
    };
    ShotClocks clocks{limitOf};
};

TEST_F(Clocks, NothingRunsBeforeTheFirstShot) {
    EXPECT_FALSE(clocks.left(at(0)));
    EXPECT_FALSE(clocks.latest());
}

TEST_F(Clocks, AShotThatIsJudgedWhileAnotherIsDrawnIsLateItself) {
    clocks.hear(Begins{kFirst}, at(0));
    EXPECT_EQ(clocks.left(at(1)), 4);
    phase(Kind::drawn, kFirst, 2);
    phase(Kind::judges, kFirst, 2);
    clocks.hear(Begins{kSecond}, at(3));
    EXPECT_EQ(clocks.left(at(4)), 3) << "the judging has 5 seconds from 2 on, the drawing 10 from 3 on";
    EXPECT_EQ(clocks.latest(), kFirst);
    EXPECT_EQ(clocks.judged(), kFirst);
    // Further shots begin, but they give the judging no more time.
    clocks.hear(Begins{kSecond}, at(6));
    EXPECT_EQ(clocks.left(at(6)), 1);
    clocks.hear(Done{kFirst, {}, {}});
    EXPECT_EQ(clocks.left(at(7)), 9);
    EXPECT_EQ(clocks.latest(), kSecond);
}

TEST_F(Clocks, AShotThatWaitsForItsVerdictHasTime) {
    clocks.hear(Begins{kFirst}, at(0));
    phase(Kind::drawn, kFirst, 4);
    EXPECT_FALSE(clocks.left(at(100)));
    phase(Kind::judges, kFirst, 100);
    EXPECT_EQ(clocks.left(at(101)), 4);
    phase(Kind::recalls, kFirst, 102);
    EXPECT_FALSE(clocks.left(at(103)));
}

TEST_F(Clocks, WhoIsAwaitedIsLate) {
    clocks.hear(Begins{kFirst}, at(0));
    phase(Kind::awaits, kSecond, 1);
    EXPECT_EQ(clocks.latest(), kSecond);
    EXPECT_EQ(clocks.left(at(2)), 9);
    phase(Kind::awaits, kFirst, 3);
    EXPECT_EQ(clocks.latest(), kFirst);
}

TEST_F(Clocks, WithoutALimitThereIsNone) {
    clocks.hear(Begins{kUnlimited}, at(0));
    EXPECT_EQ(clocks.left(at(1e6)), 0) << "0 is no limit";
    EXPECT_FALSE(clocks.latest());
    phase(Kind::judges, kFirst, 0);
    EXPECT_EQ(clocks.left(at(1)), 4);
}

TEST_F(Clocks, AMomentIsLeftToReportALateShot) {
    clocks.hear(Begins{kFirst}, at(0));
    EXPECT_GT(clocks.left(at(50)), 0) << "0 would be no limit";
}

/// A worker that a scene has taken over may send anything.
TEST_F(Clocks, NoFloodOfMessagesKeepsAWorkerAlive) {
    for (const Kind kind : {Kind::awaits, Kind::drawn, Kind::judges, Kind::recalls}) {
        ShotClocks flooded(limitOf);
        double now = 0;
        for (int i = 0; i < 1000; ++i, now += 1) {
            flooded.hear(Begins{i % 2 == 0 ? kFirst : kSecond}, at(now));
            flooded.hear(Phase{kind, i % 3 == 0 ? kFirst : kSecond}, at(now));
        }
        const std::optional<double> left = flooded.left(at(now));
        EXPECT_TRUE(!left || *left < .01) << static_cast<char>(kind);
    }
}

}  // namespace
}  // namespace glibra::suite
