#pragma once
// Finds the loops of a scene's shaders that may never end, or end only after a very long time. A software
// rasteriser has no reset that would end them.

#include <glibra/diagnostic.h>

#include <vector>

#include "glsl/types/counted_loop.h"
#include "glsl/types/translated_program.h"
#include "plan/frame_plan.h"
#include "render/load/programs.h"

namespace glibra::render {

/// The places of the loops of a stage whose number of rounds does not follow from its text and the values of
/// its uniforms, or which run more than 20,000 rounds. `uniform` gives the value of a uniform, if it is
/// known.
std::vector<Place> openLoops(const glsl::TranslatedStage& stage, const glsl::UniformValue& uniform);

/// The places of the `for` and `while` loops of a stage whose condition nothing in them can change, and which
/// nothing else leaves: they never end, so compilers remove them with all that follows.
std::vector<Place> endlessLoops(const glsl::TranslatedStage& stage);

/// Puts view-W02 for the endless loops of the plan's programs in the place of what follows from them: that a
/// uniform of such a program is unused (glib-W24) or its output missing (draw-W10), because the compiler has
/// removed them. `scene` is what the plan is of.
void explainRemovedLoops(const scene::Scene& scene, const plan::FramePlan& plan, ProgramLibrary& programs,
                         Diagnostics& diagnostics);

}  // namespace glibra::render
