#include "view/session/frame_cost.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glibra::test {
namespace {

using view::FramePacer;

constexpr double kSeconds = 10;

/// The number of frames in ten seconds of a simulated clock, which only advances by waiting and drawing.
/// `said` is the reported refresh rate. `draw` maps the time at which a frame begins to the time at which
/// presenting it returns. Events end every wait after `events` seconds.
template <class Draw>
int framesDrawn(double said, bool waits, double events, Draw draw) {
    FramePacer pacer(said, waits);
    double now = 0;
    int frames = 0;
    while (now < kSeconds) {
        now += std::min(events, pacer.secondsToNext(now));
        // Real systems sleep a little longer than requested.
        while (pacer.secondsToNext(now) > 0) now += pacer.secondsToNext(now) + 1e-5;
        pacer.begin(now);
        ++frames;
        now = draw(now);
    }
    return frames;
}

TEST(FramePacer, KeepsTheRateWhereTheDriverDoesNotWait) {
    for (const double rate : {30.0, 60.0, 144.0}) {
        const int frames = framesDrawn(rate, false, 1, [](double now) { return now + .002; });
        EXPECT_NEAR(frames, kSeconds * rate, kSeconds * rate * .01);
    }
}

TEST(FramePacer, EventsDoNotHurryIt) {
    const int frames = framesDrawn(60, false, .0005, [](double now) { return now + .002; });
    EXPECT_NEAR(frames, 600, 6);
}

TEST(FramePacer, ASlowSceneIsNotSlowedDownFurther) {
    EXPECT_NEAR(framesDrawn(60, false, 1, [](double now) { return now + .025; }), 400, 1);
}

TEST(FramePacer, KeepsAScreensRateNearlyWhereTheDriverWasToldNotToWait) {
    const int frames = framesDrawn(60, true, 1, [](double now) { return now + .002; });
    EXPECT_GE(frames, 600);
    EXPECT_LE(frames, 670);
}

TEST(FramePacer, MissesNoPictureOfAScreenThatTheDriverWaitsFor) {
    // A screen rarely has exactly the rate that it reports: 59.94 is reported as 60 or 59.
    for (const double actual : {59.94, 60.0, 60.1, 75.0, 143.86})
        for (const double said : {std::floor(actual), std::round(actual)}) {
            const int frames = framesDrawn(said, true, 1, [&](double now) {
                // Presenting returns at the next retrace of the screen.
                return (std::floor((now + .003) * actual + 1e-6) + 1) / actual;
            });
            EXPECT_NEAR(frames, kSeconds * actual, 2) << actual << " reported as " << said;
        }
}

}  // namespace
}  // namespace glibra::test
