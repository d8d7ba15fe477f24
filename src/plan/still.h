#pragma once
// Finds what of a frame is the same as in the frame before, so that it need not be drawn again: the shadow
// map of a light that stands still, the pictures of a surrounding in which nothing moves.

#include <functional>
#include <vector>

#include "plan/accesses.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

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
