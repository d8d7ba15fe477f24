#pragma once
// Do the outputs of a fragment stage fit the targets of the pass?

#include "plan/program_interface.h"
#include "scene/scene.h"

namespace glibra::plan {

/// Returns draw-E11 for each output whose kind (floating, signed or unsigned integer) differs from that of
/// the texels which it writes: OpenGL leaves the result undefined (GL 4.6, 17.4.4). A target without colour
/// writes does not count. Empty for classic scenes, whose targets hold no integers, and for drivers below
/// GL 4.3, which do not list outputs.
Diagnostics outputProblems(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass,
                           const ProgramInterface& interface);

}  // namespace glibra::plan
