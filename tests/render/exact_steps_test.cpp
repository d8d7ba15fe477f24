// The steps of a simulation at any time: as many as time and rate say, each of them once and in order.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "modern_text.h"
#include "render/simulation/simulation.h"

namespace glibra::test {
namespace {

TEST(ModernSteps, AreCountedExactlyUpToAMillionSeconds) {
    // A step of a slow rate ends at a whole second, also where 1 / rate is no double.
    for (const int seconds : {2, 3, 7, 10, 30, 49, 997}) {
        const double rate = 1. / seconds;
        std::int64_t wrong = 0;
        for (std::int64_t step = 1; step * seconds <= 1'000'000; ++step) {
            const auto time = static_cast<double>(step * seconds);
            wrong += render::stepsAt(time, rate) == step ? 0 : 1;
            wrong += render::stepsAt(time - .001 * seconds, rate) == step - 1 ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0) << seconds;
    }
    // The frame n of an animation has seen n steps of its own rate, however the time is rounded.
    for (const int rate : {24, 25, 30, 48, 50, 60, 90, 120, 144, 1000}) {
        std::int64_t wrong = 0;
        for (std::int64_t frame = 0; frame <= 1'000'000; frame += frame < 1000 ? 1 : 97)
            wrong += render::stepsAt(static_cast<double>(frame) / rate, rate) == frame ? 0 : 1;
        EXPECT_EQ(wrong, 0) << rate;
    }
}

/// Counts its steps, and mixes them into a number that every step changes.
std::string countingScene(const std::string& rate, const std::string& tags) {
    return R"(WindowSize 2 2
Buffer seen uint 4
Compute inline
#version 430 core
layout(local_size_x = 1) in;
uniform float uTick, uTime;
layout(std430) buffer seen { uint all[]; };
void main() {
    all[0] += 1u;
    all[1] = all[1] * 1664525u + 1013904223u;
    all[2] = uint(uTick);
    all[3] = floatBitsToUint(uTime);
}
EndCompute
Program Count )" +
           tags + "\nStep " + rate + R"(
    Dispatch Count 1 1 1
EndStep
Fragment inline
#version 430 core
layout(std430) readonly buffer seen { uint all[]; };
out vec4 fColor;
void main() { fColor = vec4(float(all[0] & 255u) / 255.); }
EndFragment
Program Show
Fill window with Show
)";
}

double mixed(std::int64_t steps) {
    std::uint32_t value = 0;
    for (std::int64_t i = 0; i < steps; ++i) value = value * 1664525U + 1013904223U;
    return value;
}

TEST(ModernSteps, BeyondAHundredThousandEachRunOnce) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    RenderOptions options;
    options.steps = 100'002;
    TextScene scene(countingScene("1000", "uTick 0 uTime 0"), {}, options);
    scene.draw(100.002);
    EXPECT_EQ(scene.buffer("seen", 2), (std::vector<double>{100'002, mixed(100'002)}));
    scene.draw(100.5);  // goes on from where it stood
    EXPECT_EQ(scene.buffer("seen", 2), (std::vector<double>{100'500, mixed(100'500)}));
    scene.draw(.0425);  // begins anew
    EXPECT_EQ(scene.buffer("seen", 2), (std::vector<double>{42, mixed(42)}));
}

TEST(ModernSteps, OfSlowRatesKnowTheirTickAndTime) {
    if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    TextScene scene(countingScene("(1 / 3000)", "uTick (tick) uTime (time)"));
    for (const double time : {2999.9, 3000., 9000., 999'000., 1e6, 1e6 + 1999, 1e6 + 2000}) {
        scene.draw(time);
        const auto steps = static_cast<std::int64_t>(std::floor((time + .001) / 3000));
        const auto last = static_cast<float>(static_cast<double>(steps - 1) / (1. / 3000));
        std::uint32_t bits = 0;
        std::memcpy(&bits, &last, sizeof bits);
        const std::vector<double> expected =
            steps == 0 ? std::vector<double>(4)
                       : std::vector<double>{static_cast<double>(steps), mixed(steps),
                                             static_cast<double>(steps - 1), static_cast<double>(bits)};
        EXPECT_EQ(scene.buffer("seen", 4), expected) << time;
    }
}

}  // namespace
}  // namespace glibra::test
