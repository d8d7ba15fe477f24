#include "plan/frame_plan.h"

namespace glibra::plan {

scene::NodeIndex FramePlan::declared(const scene::NodeIndex& node) const {
    switch (node.kind) {
        case scene::NodeIndex::Kind::pass:
            return {node.kind, passes.at(node.index).pass};
        case scene::NodeIndex::Kind::dispatch:
            return {node.kind, dispatches.at(node.index).dispatch};
        case scene::NodeIndex::Kind::clear:
            break;
    }
    return {node.kind, clears.at(node.index).clear};
}

const Place& FramePlan::placeOf(const scene::NodeIndex& node) const {
    return nodes->placeOf(declared(node));
}

}  // namespace glibra::plan
