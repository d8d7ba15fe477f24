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
    /// Returns the largest patchError in pixels of all patches that the uniforms affect, from the first
    /// values to the second.
    std::function<std::optional<double>(std::span<const LevelValue> coarse, std::span<const LevelValue> fine)>
        error;
};

struct LeastLevels {
    std::vector<LevelValue> values;
    double pixels = 0;
    bool isKept = false;  ///< pixels <= maxError
};

/// The uniforms keep their proportions as far as their ranges allow. The reference is the surface with the
/// highest values that the ranges allow. Its own error is included: the error falls with the square of the
/// level, so it is a third of the difference that halving the levels makes. Returns nothing if the error
/// cannot be measured.
std::optional<LeastLevels> leastLevels(const LevelsRequest& request);

}  // namespace glibra::budget
