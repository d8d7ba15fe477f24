#pragma once
// What of a frame can be seen: backwards from the window to the passes whose targets are sampled on the way
// (skip rules of the design).

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "plan/frame_plan.h"

namespace glibra::plan {

enum class StepNeed { needed, coveredByClear, drawsNothing, outOfSight, passNotNeeded };

/// An element for each of the scene's passes, of each pass's steps, and of textures.
struct Needs {
    std::vector<bool> passes;
    std::vector<std::vector<StepNeed>> steps;
    scene::List<bool, scene::Texture> textures;  ///< sampled by a needed draw, or target of a needed pass
    std::map<const scene::Draw*, std::string> outOfSight;  ///< why, for each such step
    Place clear;  ///< of the last Clear of the window, if steps are coveredByClear
};

/// Textures that a draw's active samplers and images read.
using TexturesOf =
    std::function<std::vector<scene::TextureIndex>(const scene::Draw& draw, const scene::Pass& pass)>;
/// PlanOptions::outOfSight.
using OutOfSight = std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)>;

/// What finding needs has to ask. `texturesOf` is called once for each needed draw, passes from last to
/// first; `mayWriteImages` only where something is not needed anyway; `outOfSight`, which may be empty, once
/// for each draw that is needed otherwise.
struct NeedQuestions {
    TexturesOf texturesOf;
    MayWriteImages mayWriteImages;
    OutOfSight outOfSight{};
};

/// Needed are: the window's draws after its last Clear; every draw of a pass whose target a needed draw reads
/// at any place of the frame (a target keeps its content until it is drawn to again); what shares the depth
/// buffer with such a pass before it and is not cleared; every pass that may write to an image, and the
/// window's draws up to the last such one (its depth tests may depend on them). Of these, draws out of sight
/// are not. `everything`: all are needed.
Needs findNeeds(const scene::Scene& scene, const NeedQuestions& questions, bool everything);

/// True if the built-in program draws: there is no program, or it lacks a vertex or a fragment stage (2.2).
bool usesBuiltin(const scene::Scene& scene, const scene::Draw& draw);

}  // namespace glibra::plan
