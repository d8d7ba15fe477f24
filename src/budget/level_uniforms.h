#pragma once
// The uniforms of a program that decide tessellation levels and nothing else.

#include <vector>

#include "plan/frame_plan.h"

namespace glibra::budget {

struct LevelUniform {
    plan::UniformIndex uniform{};
    double value = 0;
    /// The range of its slider. Without a slider: 1 to the driver's highest level.
    double least = 1, most = 64;
};

/// The uniforms that TranslatedProgram::levelUniforms names and to which the scene gives a single value above
/// 0.
std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel);

}  // namespace glibra::budget
