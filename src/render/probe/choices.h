#pragma once
// What options.maxError chooses for a scene, by small pictures of it.

#include <memory>

#include "render/scene_state.h"

namespace glibra::render {

/// True if the scene declares a variable with Bound.
bool hasBounds(const scene::Scene& scene);

/// Chooses the values of what the scene declares with Bound. Its state is then made anew.
Result<std::unique_ptr<SceneState>> chooseValues(const SceneState& state, Stats& stats);

/// Chooses counts for what a first plan of the scene needs, as it is at the moment of `state`. It is then
/// planned again with the chosen shapes.
Diagnostics chooseCounts(SceneState& state, plan::PlanOptions& planOptions);

}  // namespace glibra::render
