#include "view/scene/window_draws.h"

namespace glibra::view {

std::vector<const scene::Draw*> windowDraws(const scene::Scene& scene) {
    std::vector<const scene::Draw*> draws;
    for (const scene::Pass& pass : scene.frame.passes) {
        if (!pass.isWindow) continue;
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<scene::Draw>(&step)) draws.push_back(draw);
    }
    return draws;
}

}  // namespace glibra::view
