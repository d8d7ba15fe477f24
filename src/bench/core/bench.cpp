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
constexpr double kLong = .25;        ///< seconds; for work this long, warming up does not matter
constexpr int kFewestRepeats = 5, kMostRepeats = 101, kQuickRepeats = 3;

double seconds(const std::function<void()>& work, int inner) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < inner; ++i) work();
    return std::chrono::duration<double>(Clock::now() - start).count() / inner;
}

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
    const double first = seconds(work, 1);
    const int inner = first < kShortest ? static_cast<int>(std::ceil(kShortest / std::max(first, 1e-9))) : 1;
    std::vector<double> taken{seconds(work, inner)};
    const bool isLong = std::min(first, taken.front()) > kLong;
    if (isLong) taken.push_back(first);
    double total = taken.front() * inner;
    const int fewest = isQuick() || isLong ? kQuickRepeats : kFewestRepeats;
    const int most = isQuick() || isLong ? kQuickRepeats : kMostRepeats;
    while (static_cast<int>(taken.size()) < fewest ||
           (static_cast<int>(taken.size()) < most && total < enough)) {
        taken.push_back(seconds(work, inner));
        total += taken.back() * inner;
    }
    return timingOf(std::move(taken));
}

}  // namespace glibra::bench
