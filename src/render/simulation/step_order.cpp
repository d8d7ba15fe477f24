// How many steps a time has seen, and in which order those of several blocks run (language, 12.8).

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/simulation/simulation.h"

namespace glibra::render {
namespace {

constexpr std::int64_t kLastStep = std::int64_t{1} << 62;

/// When a step is due, times the rates of both: exact for the rates and ticks of real scenes.
bool isEarlier(std::span<const double> rates, const StepNumber& a, const StepNumber& b) {
    const auto dueA = (static_cast<long double>(a.tick) + 1) * static_cast<long double>(rates[b.block]);
    const auto dueB = (static_cast<long double>(b.tick) + 1) * static_cast<long double>(rates[a.block]);
    return dueA != dueB ? dueA < dueB : a.block < b.block;
}

}  // namespace

std::int64_t stepsAt(double time, double rate) {
    const double steps = std::floor(std::fma(time, rate, 0x1p-20));
    if (!(steps > 0)) return 0;
    return steps < static_cast<double>(kLastStep) ? static_cast<std::int64_t>(steps) : kLastStep;
}

void inOrderOfTime(std::span<const double> rates, std::span<const std::int64_t> from,
                   std::span<const std::int64_t> to, const std::function<bool(StepNumber)>& run) {
    std::vector<std::int64_t> next(from.begin(), from.end());
    while (true) {
        std::optional<StepNumber> first;
        for (std::size_t block = 0; block < next.size(); ++block) {
            const StepNumber step{block, next[block]};
            if (next[block] < to[block] && (!first || isEarlier(rates, step, *first))) first = step;
        }
        if (!first || !run(*first)) return;
        ++next[first->block];
    }
}

bool canGoOn(std::span<const double> rates, std::span<const std::int64_t> done,
             std::span<const std::int64_t> to) {
    for (std::size_t ran = 0; ran < done.size(); ++ran) {
        if (to[ran] < done[ran]) return false;
        for (std::size_t comes = 0; comes < done.size(); ++comes)
            if (done[ran] > 0 && done[comes] < to[comes] &&
                isEarlier(rates, {comes, done[comes]}, {ran, done[ran] - 1}))
                return false;
    }
    return true;
}

}  // namespace glibra::render
