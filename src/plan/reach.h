#pragma once
// What dispatches and draws do not reach, or reach beyond (language, 12.7).

#include "plan/buffers.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

/// memory-W05 for invocations, vertices and instances that use elements which their buffer does not have, and
/// memory-W06 for dispatches with a single group along an axis along which a written image goes on.
Diagnostics reachProblems(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts);

}  // namespace glibra::plan
