#pragma once
// What a plan leaves out, in words, for --explain.

#include <vector>

#include "plan/frame_plan.h"
#include "plan/needs.h"

namespace glibra::plan {

/// Everything of the scene that is not in the plan, in this order: passes, draws, statements, programs,
/// meshes, attributes, textures, files; each kind in the order of the scene.
std::vector<Skipped> listSkipped(const scene::Scene& scene, const Needs& needs, const FramePlan& plan);

/// Attributes that the mesh of a shape carries or may carry, in the order of geometry's constants.
std::vector<std::string> attributesOf(const scene::Shape& shape);

}  // namespace glibra::plan
