#pragma once
// Finds textures that the frame reads before it writes them.

#include <set>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// draw-W11 for textures of a modern scene that the frame samples before a pass, dispatch or Clear of the
/// frame writes them, and for the previous copies of textures with history that only the frame writes: a
/// frame begins with both as declared, which is zero. A statement that also runs after the write, as in a
/// Repeat, is not reported, nor is one whose result the write needs. `lasting`: what Once and Step write.
Diagnostics reportEarlyReads(const scene::Scene& scene, const FramePlan& frame,
                             const std::set<scene::TextureIndex>& lasting);

}  // namespace glibra::plan
