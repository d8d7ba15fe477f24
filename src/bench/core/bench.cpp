#include "bench/core/bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace glibra::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kShortest = 20e-6;  ///< seconds; shorter work is repeated inside one measurement
constexpr int kMostTimes = 1 << 20;  ///< repeats inside one measurement, even where a clock stands still
constexpr double kLong = .25;        ///< seconds; for work this long, warming up does not matter
constexpr int kFewestRepeats = 5, kMostRepeats = 101, kQuickRepeats = 3;

/// Linear interpolation between the closest ranks; `sorted` is not empty.
double percentile(const std::vector<double>& sorted, double fraction) {
    const double place = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

Timing timingOf(std::vector<double> seconds) {
    std::ranges::sort(seconds);
    return {.median = percentile(seconds, .5),
            .low = percentile(seconds, .25),
            .high = percentile(seconds, .75),
            .repeats = static_cast<int>(seconds.size())};
}

Timing timingBy(const std::function<double(int times)>& measure, bool quick, double enough) {
    const double first = measure(1);
    int inner = 1;
    double last = measure(inner);
    const bool isLong = std::min(first, last) > kLong;
    while (last < kShortest && inner < kMostTimes) {
        const double each = std::max(last / inner, 1e-9);
        inner = std::min(std::max(2 * inner, static_cast<int>(std::ceil(kShortest / each))), kMostTimes);
        last = measure(inner);
    }
    std::vector<double> taken{last / inner};
    if (isLong) taken.push_back(first);
    double total = last;
    const int fewest = quick || isLong ? kQuickRepeats : kFewestRepeats;
    const int most = quick || isLong ? kQuickRepeats : kMostRepeats;
    while (static_cast<int>(taken.size()) < fewest ||
           (static_cast<int>(taken.size()) < most && total < enough)) {
        last = measure(inner);
        taken.push_back(last / inner);
        total += last;
    }
    return timingOf(std::move(taken));
}

struct Bench::State {
    Apart apart;  // before anything that loads a driver
    BenchOptions options;
    std::optional<gpu::Context> context;
};

Bench::Bench(const BenchOptions& options) : state_(std::make_unique<State>()) {
    state_->options = options;
}

Bench::~Bench() = default;

bool Bench::isQuick() const {
    return state_->options.quick;
}

Result<gpu::Context*> Bench::context() {
    if (!state_->context) {
        Result<gpu::Context> opened = gpu::openContext({.driver = state_->options.driver});
        if (!opened) return std::move(opened.diagnostics);
        state_->context.emplace(std::move(*opened));
    }
    return &*state_->context;
}

Apart& Bench::apart() {
    return state_->apart;
}

Timing Bench::time(const std::function<void()>& work, double enough) const {
    const auto measure = [&](int times) {
        const Clock::time_point start = Clock::now();
        for (int i = 0; i < times; ++i) work();
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    return timingBy(measure, isQuick(), enough);
}

}  // namespace glibra::bench
