#pragma once
// Which steps of a frame contribute to the picture, and which stand still.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "plan/accesses.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

class PlannedPrograms;
struct Answers;
struct PlanOptions;
struct Questions;

// ---- What is needed. Private to this room.
// Finds which steps of a frame contribute to the picture: it walks back from the window to the passes whose
// targets are sampled on the way.

enum class StepNeed : std::uint8_t { needed, coveredByClear, drawsNothing, outOfSight, passNotNeeded };

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

/// The nodes that the window or one of PlanOptions::roots depends on. It walks back through the list and
/// knows what is still read: a node is needed if it writes such an object, and what it reads is needed before
/// it. A clear of a whole target ends the need for its earlier content. Targets are seen as wholes: a pass
/// into one level of a texture that is read is needed. Where a frame begins with what the one before has left
/// (scene::Scene::goesOn), what is read at the beginning is read after the end, too. Draws that are out of
/// sight are not needed, nor are those of which that is not known: they are among the questions then. With
/// PlanOptions::everything all nodes are needed.
Needs findNeeds(const scene::Scene& scene, const scene::NodeList& nodes, PlannedPrograms& programs,
                const Answers& answers, const PlanOptions& options, Questions& questions);

// ---- What stands still
// Finds what of a frame is the same as in the frame before, so that it need not be drawn again: the shadow
// map of a light that stands still, the pictures of a surrounding in which nothing moves.

/// A scene and the plan of its frame.
struct PlannedScene {
    const scene::Scene& scene;
    const FramePlan& plan;
};

/// The nodes that need not run.
struct StillNodes {
    std::vector<bool> nodes;    ///< one per node of FramePlan::order; empty: none is still
    std::set<Object> contents;  ///< what they would write; it must keep its content
};

/// False if each node draws into the window or follows Timer, so that none can stand still. Allocates
/// nothing.
bool mayStandStill(const FramePlan& plan);

/// The nodes of `now` that would write what their objects hold after `before`, of the same scene, was
/// drawn completely and nothing else has written since. Such a node is equal in both plans and the only one
/// of its frame that writes its objects, none of which has a history or shares memory. What it reads comes
/// from other still nodes before it, or from nothing that has changed. `changed` says which objects Once and
/// Step blocks have written since. The eye of the window's passes must have stood still for passes that are
/// seen through it; draws that read Timer are never still.
StillNodes stillNodes(const PlannedScene& before, const PlannedScene& now,
                      const std::function<bool(const Object&)>& changed);

}  // namespace glibra::plan
