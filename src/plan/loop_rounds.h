#pragma once
// Loops of shaders that a driver may end too early (draw-W08).

#include <functional>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// The number of rounds that every driver allows for the loops of a shader.
inline constexpr double kRoundsOfAnyDriver = 32'768;

/// Returns one warning per stage whose loops exceed the driver's limit with the planned values of its
/// uniforms, at the place of the longest loop. `limit` returns that limit (0: none); it is called only if
/// there are more than kRoundsOfAnyDriver rounds.
Diagnostics reportLongLoops(const PlannedProgram& program, const std::function<int()>& limit);

}  // namespace glibra::plan
