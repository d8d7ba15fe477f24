#pragma once
// Which noise textures keep a bound: the part of choose() that is about them.

#include <map>
#include <string>
#include <vector>

#include "budget/budget.h"

namespace glibra::budget {

/// How a noise texture is seen.
struct NoiseUse {
    /// Pixels. Until pictures tell more, a period is taken to be one unit of the model that it is seen on;
    /// without a bound for that, half the height of the picture.
    double period = 0;
    const scene::Draw* draw = nullptr;
};

/// A texture that does not keep the bound.
struct NoiseMiss {
    double pixels = 0;
    const scene::Draw* draw = nullptr;
    std::string word, with;  ///< "Noise3D", "64 texels a side"
    bool isStated = false;   ///< the scene states its size
};

struct ChosenNoise {
    std::vector<NoiseChoice> choices;  ///< of textures that change
    std::vector<Decision> decisions;
    std::vector<NoiseMiss> misses;
};

/// `uses`: by index into Scene::textures.
ChosenNoise chooseNoise(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                        const Request& request);

}  // namespace glibra::budget
