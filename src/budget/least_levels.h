#pragma once
// The lowest tessellation levels that keep a bound, by measuring.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "budget/budget.h"
#include "budget/level_uniforms.h"

namespace glibra::budget {

struct LevelsRequest {
    std::vector<LevelUniform> uniforms;
    bool isFree = false;  ///< they may be chosen; else only their error is asked for
    double maxError = 0;  ///< pixels
    /// Largest patchError in pixels of all that the uniforms are for, from the first values to the second.
    std::function<std::optional<double>(std::span<const LevelValue> coarse, std::span<const LevelValue> fine)>
        error;
};

struct LeastLevels {
    std::vector<LevelValue> values;
    double pixels = 0;
    bool isKept = false;  ///< pixels <= maxError
};

/// The uniforms keep their proportions as far as their ranges allow. The reference are the highest values
/// that those allow; by how much it is itself beside the surface is a third of what half as many are beside
/// it, since the error falls with the square of the level, and is counted in. Nothing if it cannot be
/// measured.
std::optional<LeastLevels> leastLevels(const LevelsRequest& request);

}  // namespace glibra::budget
