#pragma once
// The part of choose() that chooses tessellation levels.

#include <glm/vec2.hpp>
#include <map>
#include <string>
#include <vector>

#include "budget/budget.h"

namespace glibra::budget {

/// A draw of patches into a picture of that size.
struct TessellatedDraw {
    std::size_t pass = 0, step = 0;  ///< indices into Scene::passes and Pass::steps
    const scene::Draw* draw = nullptr;
    glm::dvec2 size{0};  ///< pixels
};

struct ChosenLevels {
    std::vector<plan::Override> overrides;  ///< values of uniforms that decide levels
    std::vector<Decision> decisions;
    std::vector<Miss> misses;
    std::vector<Unknown> unknown;
};

/// `draws` is indexed like FramePlan::programs; all draws of one program have the same levels.
ChosenLevels chooseLevels(const scene::Scene& scene, const plan::FramePlan& plan,
                          const std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>>& draws,
                          const Request& request);

}  // namespace glibra::budget
