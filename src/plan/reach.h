#pragma once
// What dispatches and draws need of buffers and do not find, or do not reach (language, 12.7).

#include "plan/buffers.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

/// memory-E12 for draws and dispatches whose counts their buffers do not hold, then memory-W05 for
/// invocations, vertices and instances that use elements which their buffer does not have, and memory-W06 for
/// dispatches with a single group along an axis along which a written image goes on.
Diagnostics reachProblems(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts);

}  // namespace glibra::plan
