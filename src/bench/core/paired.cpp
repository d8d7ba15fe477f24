#include "bench/core/paired.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {
namespace {

constexpr double kShortestRun = 10e-3;  ///< seconds; shorter work is repeated inside one measurement
constexpr int kMostInner = 10'000;

double now(bool byProcessor) {
    timespec time{};
    ::clock_gettime(byProcessor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsEach(const std::function<void()>& work, int inner, bool byProcessor) {
    const double start = now(byProcessor);
    for (int i = 0; i < inner; ++i) work();
    return (now(byProcessor) - start) / inner;
}

/// How often the work is repeated inside one measurement. Runs it to warm up.
int innerOf(const std::function<void()>& work, bool byProcessor) {
    work();
    const double once = secondsEach(work, 1, byProcessor);
    return static_cast<int>(
        std::clamp(std::ceil(kShortestRun / std::max(once, 1e-9)), 1., double{kMostInner}));
}

}  // namespace

PairedTiming timePairs(const std::function<void()>& first, const std::function<void()>& second, int pairs,
                       bool byProcessor) {
    const int innerFirst = innerOf(first, byProcessor), innerSecond = innerOf(second, byProcessor);
    std::vector<double> firsts, seconds, ratios;
    for (int i = 0; i < pairs; ++i) {
        // Each goes first in turn, so that what grows with time favours neither.
        if (i % 2 == 0) firsts.push_back(secondsEach(first, innerFirst, byProcessor));
        seconds.push_back(secondsEach(second, innerSecond, byProcessor));
        if (i % 2 == 1) firsts.push_back(secondsEach(first, innerFirst, byProcessor));
        ratios.push_back(firsts.back() / std::max(seconds.back(), 1e-12));
    }
    return {timingOf(std::move(firsts)), timingOf(std::move(seconds)), timingOf(std::move(ratios))};
}

}  // namespace glibra::bench
