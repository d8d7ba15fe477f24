#pragma once
// The uniforms of a program that decide tessellation levels and nothing else.

#include <vector>

#include "plan/frame_plan.h"

namespace glibra::budget {

struct LevelUniform {
    plan::UniformIndex uniform{};
    double value = 0;
    double least = 1, most = 64;  ///< of its slider, or 1 and the driver's highest level
};

/// Those whose values reach gl_TessLevelOuter and gl_TessLevelInner by assignments in the control stage and,
/// as its text shows, nothing else: not a position, not a colour, not a condition. Scalars with a value of
/// the scene above 0 that `isOverridden` is not true of. Empty if the program has a geometry stage, which may
/// show the single triangles, or draws points of the tessellation, which are what is shown.
std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel);

}  // namespace glibra::budget
