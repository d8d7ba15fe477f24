#pragma once
// Finds which steps of a frame contribute to the picture: it walks back from the window to the passes whose
// targets are sampled on the way.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "plan/frame_plan.h"
#include "plan/plan_questions.h"

namespace glibra::plan {

enum class StepNeed { needed, coveredByClear, drawsNothing, outOfSight, passNotNeeded };

/// One element per pass, dispatch and clear of the list, per step of each pass, and per texture and buffer.
struct Needs {
    std::vector<bool> passes;
    std::vector<bool> dispatches, clears;
    std::vector<std::vector<StepNeed>> steps;
    scene::List<bool, scene::Texture> textures;          ///< used by a needed node: read or drawn into
    scene::List<bool, scene::Buffer> buffers;            ///< likewise
    std::map<scene::StepIndex, std::string> outOfSight;  ///< why, for each such step
    Place
        clear;  ///< of the last Clear of the window, or the pass that clears it, if steps are coveredByClear
};

/// What findNeeds() asks the planner. `usesOf` is called for each needed draw, from the last pass to the
/// first, and again if the frame goes on; the targets of the pass are not among its uses. `mayWriteImages` is
/// called only for draws that seem unnecessary. `outOfSight` may be empty; it is called once per draw that is
/// needed otherwise. Without `usesOfDispatch` no dispatch is needed.
struct NeedQuestions {
    std::function<std::vector<ObjectUse>(const scene::Draw& draw, const scene::Pass& pass)> usesOf;
    decltype(PlanQuestions::mayWriteImages) mayWriteImages;
    decltype(PlanQuestions::outOfSight) outOfSight{};
    std::function<std::vector<ObjectUse>(const scene::Dispatch& dispatch)> usesOfDispatch{};
};

/// The nodes that the window or one of `roots` depends on. It walks back through the list and knows what is
/// still read: a node is needed if it writes such an object, and what it reads is needed before it. A clear
/// of a whole target ends the need for its earlier content. Targets are seen as wholes: a pass into one level
/// of a texture that is read is needed. Where a frame begins with what the one before has left
/// (scene::Scene::goesOn), what is read at the beginning is read after the end, too. Draws that are out of
/// sight are not needed. With `everything` all nodes are.
Needs findNeeds(const scene::Scene& scene, const scene::NodeList& nodes, const NeedQuestions& questions,
                const std::vector<scene::ObjectView>& roots, bool everything);

/// True if a draw of the pass tests the stencil, or a Clear sets it.
bool usesStencil(const scene::Pass& pass);

}  // namespace glibra::plan
