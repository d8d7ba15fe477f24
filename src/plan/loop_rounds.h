#pragma once
// Loops of shaders that a driver may end too early (draw-W08).

#include <functional>

#include "plan/frame_plan.h"

namespace glibra::plan {

/// Every driver lets a shader's loops run so often.
inline constexpr double kRoundsOfAnyDriver = 32'768;

/// A warning for each stage whose loops, with these values of its uniforms, run more often than the driver
/// lets them, at the longest of them. `limit` (0: none) is asked only if there are more than
/// kRoundsOfAnyDriver.
Diagnostics reportLongLoops(const PlannedProgram& program, const std::function<int()>& limit);

}  // namespace glibra::plan
