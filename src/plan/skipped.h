#pragma once
// Describes in words what a plan leaves out, for --explain.

#include <vector>

#include "plan/frame_plan.h"
#include "plan/needs.h"

namespace glibra::plan {

/// Lists everything of the scene that is not in the plan: passes, draws, statements, programs, meshes,
/// attributes, textures, files, in this order, and each kind in the order of the scene.
std::vector<Skipped> listSkipped(const scene::Scene& scene, const Needs& needs, const FramePlan& plan);

/// The attributes that the mesh of a shape may have, in the order of the constants of geometry.
std::vector<std::string> attributesOf(const scene::Shape& shape);

}  // namespace glibra::plan
