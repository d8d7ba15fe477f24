#pragma once
// Finds the lowest tessellation levels that keep a bound, by measuring.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "budget/level_uniforms.h"

namespace glibra::budget {

struct LevelsRequest {
    std::vector<LevelUniform> uniforms;
    bool isFree = false;  ///< they may be chosen; otherwise only their error is measured
    double maxError = 0;  ///< pixels
    /// Returns the largest error in pixels of all patches that the uniforms affect, with these values.
    std::function<std::optional<double>(std::span<const LevelValue> values)> error;
};

struct LeastLevels {
    std::vector<LevelValue> values;
    double pixels = 0;
    bool isKept = false;  ///< pixels <= maxError
};

/// The uniforms keep their proportions as far as their ranges allow. Returns nothing if the error cannot be
/// measured.
std::optional<LeastLevels> leastLevels(const LevelsRequest& request);

}  // namespace glibra::budget
