#pragma once
// What the rounds of a shader's loops lead to: a driver may end them too early (draw-W08), and a geometry
// stage may emit more vertices than it declares (glsl-W27).

#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "plan/frame_plan.h"
#include "plan/texture_binding.h"

namespace glibra::plan {

/// The number of rounds that every driver allows for the loops of a shader.
inline constexpr double kRoundsOfAnyDriver = 32'768;

/// Gives the value of a size or of a block's member in a formula (glsl/types/counted_loop.h); nothing if it
/// is not known before the program runs.
using Measure = std::function<std::optional<double>(std::string_view name)>;

/// The measures that the scene shows: sizes of the textures that `units` bind, elements of buffers, and what
/// the scene writes into members of blocks.
Measure measureOf(const scene::Scene& scene, const PlannedProgram& program, std::span<const UnitUse> units);

/// Returns one warning per stage whose loops exceed the driver's limit with the planned values of its
/// uniforms, at the place of the longest loop. `limit` returns that limit (0: none); it is called only if
/// there are more than kRoundsOfAnyDriver rounds.
Diagnostics reportLongLoops(const PlannedProgram& program, const std::function<int()>& limit,
                            const Measure& measure = {});

/// True if a stage may run more than kRoundsOfAnyDriver rounds, as far as its text and the planned values
/// show: the number of rounds of a loop is not known, or too high.
bool hasOpenLoops(const PlannedProgram& program, const Measure& measure = {});

/// Returns glsl-W27 if the geometry stage emits more vertices than its layout allows, as far as the number is
/// sure.
Diagnostics reportLostVertices(const PlannedProgram& program, const Measure& measure = {});

}  // namespace glibra::plan
