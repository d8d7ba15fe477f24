#include "budget/least_levels.h"

#include <algorithm>
#include <cmath>

namespace glibra::budget {
namespace {

std::vector<LevelValue> scaled(const LevelsRequest& request, double factor) {
    std::vector<LevelValue> values;
    for (const LevelUniform& each : request.uniforms) {
        const double wanted = std::ceil(each.value * factor * 100) / 100;
        values.push_back({each.uniform, std::clamp(wanted, each.least, each.most)});
    }
    return values;
}

}  // namespace

std::optional<LeastLevels> leastLevels(const LevelsRequest& request) {
    const auto measure = [&](const std::vector<LevelValue>& values) -> std::optional<LeastLevels> {
        const std::optional<double> pixels = request.error(values);
        if (!pixels) return std::nullopt;
        return LeastLevels{values, *pixels, *pixels <= request.maxError};
    };
    if (!request.isFree) {
        std::vector<LevelValue> stated;
        for (const LevelUniform& each : request.uniforms) stated.push_back({each.uniform, each.value});
        return measure(stated);
    }
    double lowest = 1e9, highest = 0;
    for (const LevelUniform& each : request.uniforms) {
        lowest = std::min(lowest, each.least / each.value);
        highest = std::max(highest, each.most / each.value);
    }
    std::optional<LeastLevels> best = measure(scaled(request, lowest));
    if (!best || best->isKept) return best;
    best = measure(scaled(request, highest));
    if (!best || !best->isKept) return best;
    for (double tooLow = lowest, enough = highest; enough > 1.02 * tooLow;) {
        const double middle = std::sqrt(tooLow * enough);
        std::optional<LeastLevels> found = measure(scaled(request, middle));
        if (!found) return std::nullopt;
        (found->isKept ? enough : tooLow) = middle;
        if (found->isKept) best = std::move(found);
    }
    return best;
}

}  // namespace glibra::budget
