#pragma once
// Finds what a plan leaves out, and why.

#include <vector>

#include "plan/frame_plan.h"
#include "plan/needs.h"
#include "plan/skipped.h"
#include "scene/scene.h"

namespace glibra::plan {

/// Lists everything of the scene that is not in the plan: passes, draws, statements, programs, meshes,
/// attributes, textures, files, in this order, and each kind in the order of the scene.
std::vector<Skipped> listSkipped(const scene::Scene& scene, const Needs& needs, const FramePlan& plan);

}  // namespace glibra::plan
