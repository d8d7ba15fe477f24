#pragma once
// The stages of a graphics pipeline, in the order in which they run.

namespace glibra::glsl {

enum class Stage { vertex, tessControl, tessEvaluation, geometry, fragment };
inline constexpr int kStageCount = 5;

}  // namespace glibra::glsl
