#pragma once
// The part of choose() that chooses noise textures.

#include <map>
#include <string>
#include <vector>

#include "budget/budget.h"

namespace glibra::budget {

/// How a noise texture is seen.
struct NoiseUse {
    /// The size of a period in pixels. Until it has been measured, a period is taken to be one unit of the
    /// model on which the noise is seen, or half the height of the picture if there is no bound for that.
    double period = 0;
    const scene::Draw* draw = nullptr;
};

struct ChosenNoise {
    std::vector<NoiseChoice> choices;  ///< only for textures that change
    std::vector<Decision> decisions;
    std::vector<Miss> misses;
};

ChosenNoise chooseNoise(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                        const Request& request);

}  // namespace glibra::budget
