#pragma once
// Which tessellation levels keep a bound: the part of choose() that is about them.

#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <vector>

#include "budget/budget.h"

namespace glibra::budget {

/// A draw of patches, into a picture of that size.
struct TessellatedDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const scene::Draw* draw = nullptr;
    glm::dvec2 size{0};  ///< pixels
};

/// Levels that do not keep the bound.
struct LevelMiss {
    double pixels = 0;
    const scene::Draw* draw = nullptr;
    std::string with;       ///< "uOuter 64, uInner 64"
    bool isStated = false;  ///< they are the scene's own
};

struct ChosenLevels {
    std::vector<plan::Override> overrides;  ///< values of uniforms that decide levels
    std::vector<Decision> decisions;
    std::vector<LevelMiss> misses;
};

/// `draws`: by index into FramePlan::programs; the draws of one program have its levels in common.
ChosenLevels chooseLevels(const scene::Scene& scene, const plan::FramePlan& plan,
                          const std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>>& draws,
                          const Request& request);

}  // namespace glibra::budget
