#pragma once
// Finds which steps of a frame contribute to the picture: it walks back from the window to the passes whose
// targets are sampled on the way.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

enum class StepNeed { needed, coveredByClear, drawsNothing, outOfSight, passNotNeeded };

/// One element per pass of the scene, per step of each pass, and per texture.
struct Needs {
    std::vector<bool> passes;
    std::vector<std::vector<StepNeed>> steps;
    scene::List<bool, scene::Texture> textures;  ///< sampled by a needed draw, or target of a needed pass
    std::map<scene::StepIndex, std::string> outOfSight;  ///< why, for each such step
    Place clear;  ///< of the last Clear of the window, if steps are coveredByClear
};

/// Textures that a draw's active samplers and images read.
using TexturesOf =
    std::function<std::vector<scene::TextureIndex>(const scene::Draw& draw, const scene::Pass& pass)>;
/// PlanOptions::outOfSight.
using OutOfSight = std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)>;

/// The questions of findNeeds. `texturesOf` is called once per needed draw, from the last pass to the first.
/// `mayWriteImages` is called only for draws that seem unnecessary. `outOfSight` may be empty; it is called
/// once per draw that is needed otherwise.
struct NeedQuestions {
    TexturesOf texturesOf;
    MayWriteImages mayWriteImages;
    OutOfSight outOfSight{};
};

/// These are needed:
/// - the window's draws after its last Clear;
/// - every draw of a pass whose target a needed draw reads anywhere in the frame, since a target keeps its
///   content until it is drawn to again;
/// - an earlier pass with the same depth buffer as such a pass, unless that pass clears the depth;
/// - every pass that may write to an image, and the window's draws up to the last such draw, since its depth
///   tests may depend on them.
/// Draws that are out of sight are not needed. With `everything` all draws are.
Needs findNeeds(const scene::Scene& scene, const NeedQuestions& questions, bool everything);

/// True if the built-in program is used: the draw has no program, or the program lacks a vertex or a fragment
/// stage (language, 2.2).
bool usesBuiltin(const scene::Scene& scene, const scene::Draw& draw);

}  // namespace glibra::plan
